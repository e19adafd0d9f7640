#!/bin/sh
# peers.sh - the same scenes in Mitsuba 3 and in brdfcl, in turns, with their pictures compared.
#
#   bench/peers.sh [--rounds N] [--spp N] [--json FILE] [SCENE.xml]...      (default: scenes/cornell.xml)
#   SCRIPT=peers_material.py bench/peers.sh [--rounds N] [--count N] [FILE]  a measured file
#   SCRIPT=compare.py bench/peers.sh [--pairs N] [--worst] [ROW]...         models, value by value
#
# Mitsuba comes from PyPI into a virtual environment under $BUILD/peers; nothing else of Python is
# touched. It needs LLVM as a shared library: $DRJIT_LIBLLVM_PATH, or else version 19, which is
# installed with apt-get where that can be done, or else the newest there is.
set -eu

BUILD=${BUILD:-build}
BRDFCL=${BRDFCL:-$BUILD/brdfcl}
MITSUBA=${MITSUBA:-mitsuba==3.9.1}
venv=$BUILD/peers
export BUILD BRDFCL

# The newest of the libraries whose names fit; nothing if there is none.
find_llvm() {
    # shellcheck disable=SC2086 - the name is a pattern
    ls -1 /usr/lib/*/$1 /usr/lib/llvm-*/lib/$1 /usr/lib64/$1 /usr/local/lib/$1 2>/dev/null |
        sed 's|.*/libLLVM[^0-9]*\([0-9]*\).*|\1 &|' | sort -rn | sed -n '1s/^[0-9]* //p'
}

if [ -z "${DRJIT_LIBLLVM_PATH:-}" ]; then
    llvm=$(find_llvm 'libLLVM*19*')
    if [ -z "$llvm" ] && [ "$(id -u)" -eq 0 ] && command -v apt-get >/dev/null; then
        echo "brdfcl: installing with apt-get: libllvm19"
        DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends libllvm19 ||
            echo "brdfcl: that did not work; looking for another version"
        llvm=$(find_llvm 'libLLVM*19*')
    fi
    [ -n "$llvm" ] || llvm=$(find_llvm 'libLLVM*.so*')
    if [ -z "$llvm" ]; then
        echo "brdfcl: Mitsuba needs LLVM as a shared library; install libllvm19, or set DRJIT_LIBLLVM_PATH"
        exit 1
    fi
    DRJIT_LIBLLVM_PATH=$llvm
fi
export DRJIT_LIBLLVM_PATH

if [ ! -x "$BRDFCL" ]; then
    echo "brdfcl: $BRDFCL is missing: run \`make cli\` first, or \`make bench-peers\`"
    exit 1
fi
if [ ! -f "$venv/complete" ]; then
    echo "brdfcl: installing $MITSUBA and numpy into $venv"
    if ! python3 -m venv "$venv"; then
        echo "brdfcl: python3 cannot make virtual environments; on Debian: apt-get install python3-venv"
        exit 1
    fi
    "$venv/bin/pip" install -q "$MITSUBA" numpy
    : >"$venv/complete"
fi

exec "$venv/bin/python" "$(dirname "$0")/${SCRIPT:-peers.py}" "$@"
