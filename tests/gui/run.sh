#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Runs the GUI tests on a staged add-on, in FreeCADs and on screens of their own.
# Usage: tests/gui/run.sh <staged add-on folder> [name of one test]
#    or: tests/gui/run.sh <staged add-on folder> <name of a file tests_<name>.py> [name of one test]
# Several FreeCADs run beside each other, as they mostly wait: each takes the next test that none
# has begun. SHEETMORPH_GUI_LANES says how many, else one more than there are cores.
# The pictures taken on the way stay in $SHEETMORPH_GUI_OUT if that is set.
set -u
staged=$(realpath "${1:?usage: run.sh <staged add-on folder> [test]}")
only=${2:-}
here=$(dirname "$(realpath "$0")")
work=$(mktemp -d)
LONGEST=3000 # seconds; a test of "large" may take nearly as long
lanes=${SHEETMORPH_GUI_LANES:-$(($(nproc) + 1))}
touch "$work/all"
mkdir "$work/claims"

finish() {
    for job in $(jobs -p); do kill "$job" 2>/dev/null; done
    wait 2>/dev/null
    [ "$BASHPID" != "$$" ] || rm -rf "$work"
}
trap finish EXIT
trap 'exit 130' INT TERM

# A screen with a window manager; sets DISPLAY. $1: a folder for what they say.
start_screen() {
    mkfifo "$1/display"
    Xvfb -displayfd 3 -screen 0 1600x1000x24 -dpi 96 +extension GLX +render -noreset \
        -nolisten tcp 3>"$1/display" >"$1/xvfb.log" 2>&1 &
    DISPLAY=:$(head -1 "$1/display")
    export DISPLAY
    openbox >"$1/openbox.log" 2>&1 &
    for _ in $(seq 50); do
        xdotool getdisplaygeometry >/dev/null 2>&1 && return
        sleep 0.1
    done
}

# A home in folder $1 with add-on $2 in it; the default start page dies when run as root.
make_home() {
    rm -rf "$1/home" # places and settings of a FreeCAD before
    mkdir -p "$1/home/Mod"
    ln -s "$2" "$1/home/Mod/SheetMorph"
    FREECAD_USER_HOME="$1/home" freecadcmd "$here/settings.py" </dev/null >"$1/home.log" 2>&1
}

# Runs tests $2 in lane $1, those whose name has $3 in it and that nobody has claimed in folder $4.
# The results go to "results" there. One that stays at a test for LONGEST seconds is ended.
start_freecad() {
    touch "$1/running"
    FREECAD_USER_HOME="$1/home" QT_ENABLE_HIGHDPI_SCALING=0 SHEETMORPH_GUI_TESTS=$2 \
        SHEETMORPH_GUI_ONLY=$3 SHEETMORPH_GUI_CLAIMS=$4 SHEETMORPH_GUI_WORK=$1 \
        freecad "$here/inside.py" </dev/null >>"$1/freecad.out" 2>&1 &
    local freecad=$! status
    while kill -0 "$freecad" 2>/dev/null; do
        [ $(($(date +%s) - $(stat -c %Y "$1/running"))) -lt "$LONGEST" ] || kill -KILL "$freecad"
        sleep 0.5
    done
    wait "$freecad"
    status=$?
    touch "$1/results"
    # A FreeCAD that died, hung or was killed leaves no closing line.
    grep -q '^END$' "$1/results" || {
        echo "FAIL $2: FreeCAD ended with status $status in $(cat "$1/running" 2>/dev/null)"
        echo "What FreeCAD said last:"
        tail -40 "$1/freecad.out" | sed 's/^/    /'
    } >>"$1/results"
}

# A test that fails is tried once more in a fresh FreeCAD: the mouse is real, and so is the load of
# the machine. What fails twice has failed; what passes only then is counted apart.
run_tests() {
    local lane=$1 name
    start_freecad "$lane" "$2" "$only" "$work/claims"
    mv "$lane/results" "$lane/first"
    while read -r name; do
        rm -rf "$lane/claims"
        mkdir "$lane/claims"
        make_home "$lane" "$(readlink "$lane/home/Mod/SheetMorph")"
        start_freecad "$lane" "$2" "$name" "$lane/claims"
        if grep -q '^FAIL' "$lane/results"; then
            sed -n '/^FAIL/,$p' "$lane/results" | grep -v '^END$' >>"$lane/told"
        else
            printf 'PASS %s\nSECOND TRY %s\n' "$name" "$name" >>"$lane/told"
            echo "At the first try:" >>"$lane/told"
            sed -n "/^FAIL $name /,/^\(PASS\|FAIL\|END\)/p" "$lane/first" |
                sed 's/^/    /' >>"$lane/told"
        fi
    done < <(sed -n 's/^FAIL \(test_[^ ]*\).*/\1/p' "$lane/first")
    grep -E '^(PASS|SKIP|NOTE)' "$lane/first" >>"$lane/told"
    sed -nE '/^FAIL ([^t]|the tests)/,$p' "$lane/first" >>"$lane/told"
}

# Runs tests $3... with add-on $2 on a screen of their own; $1 is the name of the lane.
run_lane() {
    trap finish EXIT
    local lane="$work/$1" addon=$2 tests
    mkdir -p "$lane"
    start_screen "$lane"
    make_home "$lane" "$addon"
    for tests in "${@:3}"; do
        run_tests "$lane" "$tests"
    done
    if [ -n "${SHEETMORPH_GUI_OUT:-}" ]; then
        mkdir -p "$SHEETMORPH_GUI_OUT"
        cp "$lane"/*.png "$SHEETMORPH_GUI_OUT/" 2>/dev/null
        cp "$lane/freecad.out" "$SHEETMORPH_GUI_OUT/$1.out"
    fi
}

# Runs tests $@ in all lanes beside each other.
run_lanes() {
    local lane
    for lane in $(seq "$lanes"); do
        (run_lane "lane$lane" "$staged" "$@") &
    done
    wait
}

# The same add-on, its compiled kernel missing.
make_broken() {
    mkdir -p "$work/broken/sheetmorph"
    cp -rs "$staged/freecad" "$staged/resources" "$work/broken/"
    cp -rs "$staged/sheetmorph/." "$work/broken/sheetmorph/"
    rm -f "$work/broken/sheetmorph/"_core*
}

if [ -n "$only" ] && [ ! -f "$here/tests_$only.py" ]; then
    lanes=1
fi
if [ -f "$here/tests_$only.py" ] && [ "$only" != without_kernel ]; then
    name=$only
    only=${3:-}
    run_lanes "$name"
else
    run_lanes with_kernel hostile
    make_broken
    mkdir -p "$work/broken_lane"
    cp "$work"/lane*/saved.FCStd "$work/broken_lane/" 2>/dev/null # what a test with the kernel saved
    (run_lane broken_lane "$work/broken" without_kernel) &
    wait
fi

cat "$work"/*/told >"$work/all" 2>/dev/null
cat "$work/all"
passed=$(grep -c '^PASS' "$work/all")
failed=$(grep -c '^FAIL' "$work/all")
skipped=$(grep -c '^SKIP' "$work/all")
again=$(grep -c '^SECOND TRY' "$work/all")
echo "gui: $passed passed, $failed failed, $skipped skipped, $again only at the second try"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
