#!/bin/sh
# setup.sh - install what building and running brdfcl needs, as Debian or Ubuntu packages.
#
#   tools/setup.sh        for `make demo` and `make test`
#   tools/setup.sh ci     and for .ci/run: clang, clang-format
#
# Silent and quick where nothing is missing. Elsewhere than on Debian or Ubuntu, and without root or
# sudo, nothing is touched: what is missing is printed, and the exit status is 1.
set -eu

packages="gcc libc6-dev pkg-config ocl-icd-opencl-dev opencl-headers pocl-opencl-icd \
libopenexr-dev libpng-dev libembree-dev libassimp-dev libexpat1-dev libcmocka-dev \
libnlopt-dev liblapacke-dev libcairo2-dev"
[ "${1:-}" != ci ] || packages="$packages clang clang-format"

# Elsewhere: is it there, whoever brought it? One word for each thing that is not.
missing_things() {
    command -v cc || command -v gcc || echo gcc >&3
    if command -v pkg-config; then
        for package in OpenCL OpenEXR libpng assimp expat cmocka nlopt lapacke cairo; do
            pkg-config --exists "$package" || echo "$package" >&3
        done
    else
        echo pkg-config >&3
    fi
    ls /usr/include/embree[34]/rtcore.h /usr/local/include/embree[34]/rtcore.h 2>&1 |
        grep -v 'cannot access' || echo embree >&3
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    missing=$(missing_things 3>&1 >/dev/null 2>&1)
    [ -n "$missing" ] || exit 0
    echo "brdfcl: not found:" $missing
    echo "Install them with your system's package manager. On Debian and Ubuntu they are the packages"
    echo "    $packages"
    echo "Nothing was changed."
    exit 1
fi

# One call for all: a package that is not installed is not in its answer.
installed=" $(dpkg-query -W -f='${db:Status-Abbrev}${Package} ' $packages 2>/dev/null || true)"
missing=
for package in $packages; do
    case "$installed" in
    *"ii $package "*) ;;
    *) missing="$missing $package" ;;
    esac
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" -eq 0 ]; then
    as_root=
elif command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
    as_root=sudo
else
    echo "brdfcl: these packages are missing:$missing"
    echo "Neither root nor sudo is at hand, so nothing was changed. As root, run"
    echo "    apt-get install$missing"
    exit 1
fi

echo "brdfcl: installing with apt-get:$missing"
install_missing() {
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends \
        $missing
}
# The lists of packages are fetched where there are none, or where what they name is gone.
if ! apt-cache show $missing >/dev/null 2>&1 || ! install_missing; then
    $as_root apt-get update -q
    install_missing
fi
