#!/bin/sh
# run_tests.sh - run test programs, examples and test scripts, and count.
#
#   tools/run_tests.sh PROGRAM...
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
limit=240 # seconds for one program

# Sanitizers: what the OpenCL runtime and its compiler leave behind at exit is not ours.
UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
LSAN_OPTIONS=${LSAN_OPTIONS:-suppressions=$(pwd)/tools/lsan.supp:print_suppressions=0}
export BUILD BRDFCL UBSAN_OPTIONS LSAN_OPTIONS

mkdir -p "$logs"
total_passed=0
total_failed=0
total_skipped=0

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

for program; do
    name=$(basename "$program" .sh)
    log=$logs/$name.log
    begin=$(date +%s)
    status=0
    timeout "$limit" "./${program#./}" >"$log" 2>&1 </dev/null || status=$?
    seconds=$(($(date +%s) - begin))

    if grep -q '^\[==========\] Running ' "$log"; then
        set -- $(count_cmocka "$log")
        passed=$1 failed=$2 skipped=$3
        # A fixture of a whole group failed, or something at exit: no test says so.
        if [ "$status" -ne 0 ] && [ "$failed" -eq 0 ]; then
            failed=1
        fi
    else
        passed=0 failed=0 skipped=0
        case $status in
        0) passed=1 ;;
        77) skipped=1 ;;
        *) failed=1 ;;
        esac
    fi

    printf '  %-28s %4d passed' "$name" "$passed"
    [ "$failed" -eq 0 ] || printf ', %d FAILED' "$failed"
    [ "$skipped" -eq 0 ] || printf ', %d skipped' "$skipped"
    printf '  (%d s)\n' "$seconds"
    if [ "$failed" -ne 0 ]; then
        [ "$status" -ne 124 ] || echo "    stopped after $limit s"
        echo "    exit status $status; the end of $log:"
        tail -n 40 "$log" | sed 's/^/    | /'
    fi
    total_passed=$((total_passed + passed))
    total_failed=$((total_failed + failed))
    total_skipped=$((total_skipped + skipped))
done

echo "$total_passed passed, $total_failed failed, $total_skipped skipped"
[ "$total_failed" -eq 0 ]
