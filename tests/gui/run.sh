#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Runs the GUI tests on a staged add-on, in a FreeCAD and on a screen of their own.
# Usage: tests/gui/run.sh <staged add-on folder> [name of one test, or of one file tests_<name>.py]
# The pictures taken on the way stay in $SHEETMORPH_GUI_OUT if that is set.
set -u
staged=$(realpath "${1:?usage: run.sh <staged add-on folder> [test]}")
only=${2:-}
here=$(dirname "$(realpath "$0")")
work=$(mktemp -d)
pids=()

finish() {
    for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null; done
    wait 2>/dev/null
    rm -rf "$work"
}
trap finish EXIT

start_screen() {
    mkfifo "$work/display"
    Xvfb -displayfd 3 -screen 0 1600x1000x24 -dpi 96 +extension GLX +render -noreset \
        -nolisten tcp 3>"$work/display" >"$work/xvfb.log" 2>&1 &
    pids+=($!)
    DISPLAY=:$(head -1 "$work/display")
    export DISPLAY
    openbox >"$work/openbox.log" 2>&1 &
    pids+=($!)
    for _ in $(seq 50); do
        xdotool getdisplaygeometry >/dev/null 2>&1 && return
        sleep 0.1
    done
}

# A home of its own with the add-on in it; the default start page dies when run as root.
make_home() {
    mkdir -p "$work/$1/Mod"
    ln -s "$2" "$work/$1/Mod/SheetMorph"
    FREECAD_USER_HOME="$work/$1" freecadcmd "$here/settings.py" </dev/null >"$work/$1.log" 2>&1
}

# Runs tests $2 in the FreeCAD home $1, those whose name has $3 in it; results go to $work/$4.
start_freecad() {
    FREECAD_USER_HOME="$work/$1" QT_ENABLE_HIGHDPI_SCALING=0 SHEETMORPH_GUI_TESTS=$2 \
        SHEETMORPH_GUI_ONLY=$3 SHEETMORPH_GUI_WORK=$work \
        timeout 3000 freecad "$here/inside.py" </dev/null >"$work/$1-$4.out" 2>&1
    local status=$?
    touch "$work/results"
    mv "$work/results" "$work/$4"
    # A FreeCAD that died, hung or was killed leaves no closing line: its other tests did not run.
    grep -q '^END$' "$work/$4" ||
        echo "FAIL ${2}: FreeCAD ended with status $status before its tests did" >>"$work/$4"
}

# A test that fails is tried once more, alone in a fresh FreeCAD: the mouse is real, and so is the
# load of the machine. What fails twice has failed; what passes only then is counted apart.
run_freecad() {
    start_freecad "$1" "$2" "$only" first
    local name
    while read -r name; do
        start_freecad "$1" "$2" "$name" again
        if grep -q '^FAIL' "$work/again"; then
            sed -n '/^FAIL/,$p' "$work/again" | grep -v '^END$' >>"$work/all"
        else
            echo "PASS $name" >>"$work/all"
            echo "SECOND TRY $name" >>"$work/all"
        fi
    done < <(sed -n 's/^FAIL \(test_[^ ]*\).*/\1/p' "$work/first")
    grep -E '^(PASS|SKIP|NOTE)|^FAIL with' "$work/first" >>"$work/all"
    if [ -n "${SHEETMORPH_GUI_OUT:-}" ]; then
        mkdir -p "$SHEETMORPH_GUI_OUT"
        cp "$work"/*.png "$work"/*.out "$SHEETMORPH_GUI_OUT/" 2>/dev/null
    fi
}

# The same add-on, its compiled kernel missing.
make_broken() {
    mkdir -p "$work/broken/sheetmorph"
    cp -rs "$staged/freecad" "$staged/resources" "$work/broken/"
    cp -rs "$staged/sheetmorph/." "$work/broken/sheetmorph/"
    rm -f "$work/broken/sheetmorph/"_core*
}

start_screen
make_home home "$staged"
if [ -f "$here/tests_$only.py" ] && [ "$only" != without_kernel ]; then
    name=$only
    only=""
    run_freecad home "$name"
else
    run_freecad home with_kernel
    run_freecad home hostile
    make_broken
    make_home home2 "$work/broken"
    run_freecad home2 without_kernel
fi

cat "$work/all"
passed=$(grep -c '^PASS' "$work/all")
failed=$(grep -c '^FAIL' "$work/all")
skipped=$(grep -c '^SKIP' "$work/all")
again=$(grep -c '^SECOND TRY' "$work/all")
echo "gui: $passed passed, $failed failed, $skipped skipped, $again only at the second try"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
