#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Run as root in a fresh system by run.sh: installs what `./sheetmorph package` made, as its user
# would, morphs an example with it and takes it away again. Ends at the first thing that is wrong.
# Usage: installed.sh FOLDER, where the packages and morph.py lie
set -euo pipefail
cd "$1"
export DEBIAN_FRONTEND=noninteractive
example=/usr/lib/sheetmorph/resources/examples/door_mirror

fail() {
    printf 'installed: %s\n' "$*" >&2
    exit 1
}

as_designer() { su designer -c "cd ~ && $*"; }

# All files and links of ours, but for what lies at home.
traces() { find / -xdev -iname '*sheetmorph*' ! -path '/home/*' ! -path '/proc/*' | sort; }

morph_on_the_command_line() { # $1: the program
    rm -rf /home/designer/out
    as_designer "$1 run $example/recipe.json -o out --report out.json"
    [ "$(find /home/designer/out -name '*.obj' -o -name '*.ply' | wc -l)" -eq 3 ] ||
        fail "$1 run wrote $(ls /home/designer/out)"
}

morph_in_freecad() { # $1: the folder that the add-on must have been loaded from
    rm -f /home/designer/answer
    as_designer "MORPH_RECIPE=$example/recipe.json MORPH_ANSWER=\$HOME/answer timeout 300 \
        freecadcmd $PWD/morph.py </dev/null" >freecad.log 2>&1 || true
    [ -s /home/designer/answer ] || fail "no morph in FreeCAD: $(tail -n 5 freecad.log)"
    cat /home/designer/answer
    grep -q ", $1" /home/designer/answer || fail "not loaded from $1"
}

try_debian_package() {
    dpkg -i ./sheetmorph_*.deb
    morph_on_the_command_line sheetmorph
    morph_in_freecad /usr/
    sheetmorph doctor || fail "the installation has a fault"
    zcat /usr/share/man/man1/sheetmorph.1.gz | grep -q 'sheetmorph' || fail "no manual page"
    bash -c '. /usr/share/bash-completion/completions/sheetmorph && complete -p sheetmorph'
    cp -r "$example" examples # for those that come without
    dpkg -r sheetmorph
    [ -z "$(traces)" ] || fail "left behind: $(traces)"
    ! dpkg-query -W sheetmorph 2>/dev/null || fail "dpkg still knows it"
    echo "installed: the Debian package morphs and leaves nothing"
}

try_archive() {
    local mod
    as_designer "SHEETMORPH_ANSWER=\$HOME/where freecadcmd $PWD/ask_freecad.py </dev/null" >/dev/null
    mod=$(sed -n 5p /home/designer/where)/Mod
    as_designer "mkdir -p $mod && cd $mod && unzip -q $PWD/SheetMorph-*.zip"
    morph_in_freecad "$mod/"
    as_designer "rm -r $mod/SheetMorph"
    echo "installed: the archive morphs"
}

# In an environment that sees the system's numpy, jsonschema, jinja2 and meshio; nothing is downloaded.
try_wheel() {
    as_designer "python3 -m venv --system-site-packages wheel &&
        wheel/bin/pip install --quiet --no-index $PWD/sheetmorph-*.whl"
    morph_on_the_command_line wheel/bin/sheetmorph
    as_designer "wheel/bin/pip uninstall --quiet --yes sheetmorph && ! ls wheel/bin/sheetmorph"
    echo "installed: the wheel morphs"
}

apt-get update >/dev/null
apt-get install -y --no-install-recommends ./sheetmorph_*.deb freecad freecad-python3 \
    python3-pivy python3-scipy unzip python3-venv bash-completion >apt.log 2>&1 ||
    fail "apt-get install failed: $(tail -n 5 apt.log)"
dpkg -r sheetmorph
[ -z "$(traces)" ] || fail "left behind: $(traces)"
try_debian_package
example=$PWD/examples
try_archive
if ls ./*.whl >/dev/null 2>&1; then
    try_wheel
fi
echo "installed: $(echo ./*.deb ./*.zip ./*.whl | sed 's/ \.\/\*\.whl//')"
