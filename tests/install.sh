#!/bin/sh
# install.sh - what `make install` puts on a machine is enough to build and run every example.
#
# Each example names in its first line, "/* needs: brdf OpenCL */", the pkg-config packages that it is
# built with, and is built with nothing else. Then: staging under DESTDIR, the static library, the
# headers each by itself, and uninstall.
set -eu

# A library built for the sanitizers asks more of its users than its .pc files say.
[ -z "${SANITIZE:-}" ] || exit 77

BUILD=${BUILD:-build}
MAKE=${MAKE:-make}
CC=${CC:-cc}
strict="-std=c99 -pedantic-errors -Wall -Wextra -Werror -ffp-contract=off"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/usr

fail() {
    echo "install.sh: $*"
    exit 1
}

quiet() { # quiet COMMAND...: its output matters only if it fails
    "$@" >"$work/output" 2>&1 || {
        cat "$work/output"
        fail "failed: $*"
    }
}

make_it() {
    quiet $MAKE --no-print-directory BUILD="$BUILD" CC="$CC" "$@"
}

make_it install PREFIX="$prefix"
PKG_CONFIG_PATH=$prefix/lib/pkgconfig${PKG_CONFIG_PATH:+:$PKG_CONFIG_PATH}
LD_LIBRARY_PATH=$prefix/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export PKG_CONFIG_PATH LD_LIBRARY_PATH

# The command runs from where it was installed, with its own libraries' version.
version=$(pkg-config --modversion brdfcl)
[ "$version" = "$(pkg-config --modversion brdf)" ] || fail "brdf.pc and brdfcl.pc differ in version"
quiet "$prefix/bin/brdfcl" models
[ -s "$prefix/share/man/man1/brdfcl.1" ] || fail "no man page"

# libbrdf needs the C library and nothing else: that is what lets anyone embed it.
needed=$(LC_ALL=C objdump -p "$prefix/lib/libbrdf.so" | awk '/NEEDED/ { print $2 }' |
    grep -v -e '^libm\.' -e '^libc\.' || true)
[ -z "$needed" ] || fail "libbrdf.so needs $needed"
# What is not in a header must not be in the way of a client's own names either.
foreign=$(nm -D --defined-only "$prefix"/lib/libbrdf.so "$prefix"/lib/libbrdfcl.so |
    awk 'NF == 3 && $3 !~ /^brdf(cl)?_/ { print $3 }')
[ -z "$foreign" ] || fail "exported without our prefix: $foreign"

count=0
for source in examples/*.c; do
    [ -e "$source" ] || break
    needs=$(sed -n '1s|^/\* needs: \(.*\) \*/$|\1|p' "$source")
    [ -n "$needs" ] || fail "$source: its first line should be \"/* needs: brdf */\" or the like"
    program=$work/$(basename "$source" .c)
    # shellcheck disable=SC2086
    quiet $CC $strict "$source" -o "$program" $(pkg-config --cflags --libs $needs)
    (cd "$work" && quiet "$program") || fail "$source: failed, built with $needs"
    if [ "$needs" = brdf ]; then
        quiet $CC $strict "$source" -o "$program" $(pkg-config --cflags brdf) \
            "$prefix/lib/libbrdf.a" -lm
        (cd "$work" && quiet "$program") || fail "$source: failed with libbrdf.a"
    fi
    echo "$source: built with $needs and run"
    count=$((count + 1))
done
[ "$count" -gt 0 ] || fail "there are no examples"

# Every public header can be included first and alone, but for a list and what is not C.
for header in include/brdf/*.h include/brdf/model/*.h include/brdfcl/*.h; do
    case ${header#include/brdf/} in models.h | dialect_opencl.h | dialect_wide.h) continue ;; esac
    name=${header#include/}
    printf '#include <%s>\nint main(void) { return 0; }\n' "$name" >"$work/alone.c"
    quiet $CC $strict -Wno-unused-function $(pkg-config --cflags brdfcl) -fsyntax-only "$work/alone.c"
done

# A package is staged under DESTDIR and says where it will be, not where it was staged.
make_it install DESTDIR="$work/stage" PREFIX=/usr
(cd "$work/stage/usr" && find . | LC_ALL=C sort) >"$work/staged"
(cd "$prefix" && find . | LC_ALL=C sort) >"$work/installed"
quiet diff "$work/staged" "$work/installed"
! grep -q "$work" "$work"/stage/usr/lib/pkgconfig/*.pc || fail "a .pc file names the staging folder"

make_it uninstall PREFIX="$prefix"
left=$(find "$prefix" ! -type d)
[ -z "$left" ] || fail "uninstall left $left"
echo "installed, staged and removed; $count examples"
