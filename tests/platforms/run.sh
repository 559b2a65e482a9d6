#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Makes another Debian in a folder below build/platforms and does there what a new user would type:
# the README's two commands; makes the packages there and tries them in a fresh system of its kind. Called by `./sheetmorph test platforms [12|13|testing]...`, as root.
# Usage: tests/platforms/run.sh BUILD [SYSTEM...]
# What it needs of this machine: debootstrap, and the mirror that its apt knows.
# With CCACHE_DIR set, what is compiled in a system is kept there, in a folder of the system's name.
set -euo pipefail

root=$(dirname "$(dirname "$(dirname "$(realpath "$0")")")")
build=$(realpath "$1")/platforms
shift
[ "$#" -gt 0 ] || set -- 13 testing
mounted=()
cache=${CCACHE_DIR:-}
[ -z "$cache" ] || export CCACHE_DIR=/var/cache/ccache

finish() {
    local place
    for place in "${mounted[@]}"; do umount -l "$place" || true; done
    mounted=()
}
trap finish EXIT
trap 'exit 130' INT TERM

fail() {
    printf 'platforms: %s\n' "$*" >&2
    exit 1
}

# The suite a system is made of, and debootstrap's script for it: names may be newer than the script.
suite_of() {
    case "$1" in
        12) echo bookworm sid ;;
        13) echo trixie sid ;;
        testing) echo testing sid ;;
        *) fail "no system '$1'; there are 12, 13 and testing" ;;
    esac
}

# A bare system with a user who may become root, made once and kept as an archive.
make_bare() {
    local system="$1" folder="$build/$1-bare" mirror suite script
    [ ! -e "$folder.tar" ] || return 0
    read -r suite script < <(suite_of "$system")
    mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Component: main' | head -n 1)
    [ -n "$mirror" ] || fail "apt of this machine names no mirror to take a Debian from"
    rm -rf "$folder"
    mkdir -p "$folder"
    debootstrap --variant=minbase --include=ca-certificates,sudo "$suite" "$folder" "$mirror" \
        "/usr/share/debootstrap/scripts/$script" >"$folder.log" 2>&1 ||
        fail "debootstrap failed: $(tail -n 3 "$folder.log") (all of it: $folder.log)"
    # The lists of testing may be older than they say they are good for.
    echo 'Acquire::Check-Valid-Until "false";' >"$folder/etc/apt/apt.conf.d/90dates"
    echo force-unsafe-io >"$folder/etc/dpkg/dpkg.cfg.d/fast" # thrown away after all
    chroot "$folder" useradd --create-home --shell /bin/bash designer
    echo 'designer ALL=(ALL) NOPASSWD: ALL' >"$folder/etc/sudoers.d/designer"
    rm -rf "$folder"/var/cache/apt/archives/*.deb
    tar -C "$folder" -cf "$folder.tar.new" .
    mv "$folder.tar.new" "$folder.tar"
    rm -rf "$folder"
}

# A bare system in a folder of its own.
unpack_bare() {
    make_bare "$1"
    rm -rf --one-file-system "$2"
    mkdir -p "$2"
    tar -C "$2" -xf "$build/$1-bare.tar"
}

# The system that is built in; what a run installs there stays for the next one.
make_system() {
    local folder="$build/$1"
    [ ! -e "$folder/.made" ] || return 0
    unpack_bare "$1" "$folder"
    [ -z "$cache" ] || chroot "$folder" sh -c 'apt-get update && apt-get install -y ccache' \
        >"$folder.log" 2>&1 || fail "no ccache for $1: see $folder.log"
    touch "$folder/.made"
}

# A folder of a system, $2, that outlives it in $3.
keep() {
    mkdir -p "$1$2" "$3"
    mount --bind "$3" "$1$2"
    mounted=("$1$2" "${mounted[@]}")
}

# What a running system has besides its files, and the data beside the project.
enter_system() {
    local folder="$1" place
    for place in proc sys dev dev/pts; do
        mount --bind "/$place" "$folder/$place"
        mounted=("$folder/$place" "${mounted[@]}")
    done
    mount -t tmpfs tmpfs "$folder/dev/shm"
    mounted=("$folder/dev/shm" "${mounted[@]}")
    keep "$folder" /var/cache/apt/archives "$build/$system-debs"
    if [ -n "$cache" ]; then
        keep "$folder" "$CCACHE_DIR" "$cache/$system"
        chroot "$folder" chown designer: "$CCACHE_DIR"
    fi
    cp -L /etc/resolv.conf "$folder/etc/resolv.conf" 2>/dev/null || true
    cp -L /etc/hosts "$folder/etc/hosts"
    if [ -d "$root/../shared" ]; then
        mkdir -p "$folder/home/designer/shared"
        mount --bind -o ro "$root/../shared" "$folder/home/designer/shared"
        mounted=("$folder/home/designer/shared" "${mounted[@]}")
    fi
}

# The files of this clone as they are now, without what git does not know.
copy_clone() {
    local clone="$1/home/designer/sheetmorph"
    mkdir -p "$clone"
    find "$clone" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
    git -C "$root" ls-files -z --cached --others --exclude-standard |
        (cd "$root" && tar --null --ignore-failed-read -T - -cf -) 2>/dev/null | tar -xf - -C "$clone"
    chroot "$1" chown -R designer: /home/designer/sheetmorph
}

as_designer() {
    local folder="$1"
    shift
    chroot "$folder" su designer -c "cd ~/sheetmorph && $*"
}

# One command, $3..., for a system; its closing line and how long it took.
try() {
    local folder="$1" name="$2" start status=0
    shift 2
    start=$(date +%s)
    "$@" >"$folder-$name.log" 2>&1 </dev/null || status=$?
    printf 'platforms: %s: %s: %s, %d min: %s\n' "$(basename "$folder")" "$name" \
        "$([ "$status" -eq 0 ] && echo passed || echo "failed with $status")" \
        $((($(date +%s) - start + 30) / 60)) "$(tail -n 1 "$folder-$name.log")"
    return "$status"
}

# The packages that were made in one system, $1, in a fresh one, $2, that has nothing to build with.
try_packages() {
    local packages=/home/designer/packages
    unpack_bare "$system" "$2"
    enter_system "$2"
    cp -r "$1/home/designer/sheetmorph/build/package" "$2$packages"
    cp "$root"/tests/platforms/{installed.sh,morph.py} "$root/resources/packaging/ask_freecad.py" \
        "$2$packages"
    chroot "$2" chown -R designer: "$packages"
    try "$1" installed chroot "$2" "$packages/installed.sh" "$packages"
}

[ "$(id -u)" -eq 0 ] || fail "making a system in a folder needs root: sudo ./sheetmorph test platforms"
mkdir -p "$build"
failed=0
for system in "$@"; do
    folder="$build/$system"
    make_system "$system"
    enter_system "$folder"
    copy_clone "$folder"
    try "$folder" run as_designer "$folder" ./sheetmorph run || failed=1
    rm -rf "$folder-pictures"
    cp -r "$folder/home/designer/sheetmorph/build/run/output" "$folder-pictures" 2>/dev/null || true
    try "$folder" package as_designer "$folder" ./sheetmorph package || failed=1
    try_packages "$folder" "$folder-fresh" || failed=1
    try "$folder" test as_designer "$folder" ./sheetmorph test || failed=1
    finish
done
exit "$failed"
