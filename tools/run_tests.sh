#!/bin/sh
# run_tests.sh - run test programs, examples and test scripts, and count.
#
#   [JOBS=N] [LIMIT=SECONDS] tools/run_tests.sh PROGRAM...      N at a time, each at most so long
#
# A cmocka program counts as many times as it has tests; any other program or script counts once:
# exit status 0 passed, 77 skipped, anything else failed. What each one said is kept in
# $BUILD/tests/NAME.log, and shown where something failed. The last line is
#
#   N passed, N failed, N skipped
set -eu

BUILD=${BUILD:-build}
BRDFCL=$(pwd)/$BUILD/brdfcl
case "$BUILD" in /*) BRDFCL=$BUILD/brdfcl ;; esac
logs=$BUILD/tests
limit=${LIMIT:-240} # seconds for one program
# The longest first, so that none of them is left to run alone at the end.
long='test_models_sampling cli add_model test_models_opencl test_render_bits test_models_energy'

# Sanitizers: what the OpenCL runtime and its compiler leave behind at exit is not ours.
UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
LSAN_OPTIONS=${LSAN_OPTIONS:-suppressions=$(pwd)/tools/lsan.supp:print_suppressions=0}
export BUILD BRDFCL UBSAN_OPTIONS LSAN_OPTIONS

# Counts of a cmocka log: "passed failed skipped". Failures are named again in the summary of each
# group, after "N test(s) run.", and must not count twice; a test that began and never ended took the
# program with it.
count_cmocka() {
    awk '
        /^\[ RUN      \]/ { open = 1 }
        open && /^\[       OK \]/ { ++passed; open = 0 }
        open && /^\[  FAILED  \]/ { ++failed; open = 0 }
        open && /^\[  SKIPPED \]/ { ++skipped; open = 0 }
        END { print passed + 0, failed + open, skipped + 0 }' "$1"
}

# Run one program, leave its counts in NAME.counts, and say how it went, in one piece.
run_one() {
    program=$1
    name=$(basename "$program" .sh)
    log=$logs/$name.log
    begin=$(date +%s)
    status=0
    timeout "$limit" "./${program#./}" >"$log" 2>&1 </dev/null || status=$?
    seconds=$(($(date +%s) - begin))

    if grep -q '^\[==========\] Running ' "$log"; then
        set -- $(count_cmocka "$log")
        # A fixture of a whole group failed, or something at exit: no test says so.
        if [ "$status" -ne 0 ] && [ "$2" -eq 0 ]; then
            set -- "$1" 1 "$3"
        fi
    else
        case $status in
        0) set -- 1 0 0 ;;
        77) set -- 0 0 1 ;;
        *) set -- 0 1 0 ;;
        esac
    fi
    echo "$@" >"$logs/$name.counts"

    row=$(printf '  %-28s %4d passed' "$name" "$1")
    [ "$2" -eq 0 ] || row="$row, $2 FAILED"
    [ "$3" -eq 0 ] || row="$row, $3 skipped"
    row="$row  ($seconds s)"
    if [ "$2" -ne 0 ]; then
        [ "$status" -ne 124 ] || row="$row: stopped, it may take $limit s"
        row="$row
    exit status $status; the end of $log:
$(tail -n 40 "$log" | sed 's/^/    | /')"
    fi
    echo "$row"
}

if [ "$1" = --one ]; then
    run_one "$2"
    exit 0
fi

longest_first() {
    for name in $long; do
        printf '%s\n' "$@" | grep -E "(^|/)$name(\.sh)?\$" || true
    done
    printf '%s\n' "$@" | grep -v -E "(^|/)($(echo "$long" | tr ' ' '|'))(\.sh)?\$" || true
}

mkdir -p "$logs"
rm -f "$logs"/*.counts
# As many at a time as there are processors: compiling kernels, for one, keeps only one busy.
longest_first "$@" | xargs -n 1 -P "${JOBS:-1}" "$0" --one

cat "$logs"/*.counts | awk -v programs=$# '
    { passed += $1; failed += $2; skipped += $3 }
    END {
        failed += programs - NR # one that left no counts
        printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped
        exit failed > 0
    }'
