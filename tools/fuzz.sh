#!/bin/sh
# fuzz.sh - libFuzzer over the readers of measured files, under the address and undefined-behaviour
# sanitizers.
#
#   SECONDS_EACH=600 BUILD=build tools/fuzz.sh [TARGET...]      (default: every tests/fuzz/fuzz_*.c)
#
# Each target begins with its seeds, tests/fuzz/NAME/, and keeps what it finds worth keeping in
# $BUILD/fuzz/NAME. A finding ends the run with exit status 1 and the bytes that cause it.
set -eu

BUILD=${BUILD:-build}
SECONDS_EACH=${SECONDS_EACH:-600}
CLANG=${CLANG:-clang}

if ! command -v "$CLANG" >/dev/null; then
    echo "brdfcl: fuzzing needs clang with libFuzzer; on Debian: apt-get install clang"
    exit 1
fi
[ $# -gt 0 ] || set -- $(ls tests/fuzz/fuzz_*.c | sed 's|.*/fuzz_\(.*\)\.c|\1|')

mkdir -p "$BUILD/fuzz"
make --no-print-directory BUILD="$BUILD" "$BUILD/embedded_brdf.c"
for name in "$@"; do
    program=$BUILD/fuzz/fuzz_$name
    corpus=$BUILD/fuzz/$name
    mkdir -p "$corpus"
    echo "  fuzz    $name, $SECONDS_EACH s"
    "$CLANG" -std=c99 -O1 -g -ffp-contract=off -fsanitize=fuzzer,address,undefined \
        -fno-sanitize-recover=undefined -Iinclude -Ilib/brdf -I. \
        "tests/fuzz/fuzz_$name.c" lib/brdf/*.c "$BUILD/embedded_brdf.c" -lm -o "$program"
    "$program" -max_total_time="$SECONDS_EACH" -max_len=16384 -rss_limit_mb=2048 -timeout=60 \
        -print_final_stats=1 -verbosity=0 -artifact_prefix="$BUILD/fuzz/$name-" \
        "$corpus" "tests/fuzz/$name"
done
