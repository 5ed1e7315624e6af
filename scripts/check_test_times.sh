#!/usr/bin/env bash
# Fails if a test took over 10 s in the last run of CTest, takes that long again by itself, with no other
# beside it, and is not in tests/slow_tests.txt; and if that list names a test that is not there.
#
#   scripts/check_test_times.sh [preset]     # dev by default; asan, ten times as slow, has no limit here
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:-dev} limit=${LIMIT:-10}
[[ $preset != asan ]] || exit 0
log=build/$preset/Testing/Temporary/LastTest.log
# "seconds name" of the tests of a log.
times() {
  awk '/^[0-9]+\/[0-9]+ Testing: / { sub(/^[^:]*: /, ""); name = $0 }
       /^Test time =/ { print $4, name }' "$1"
}
known=$(grep -v '^#' tests/slow_tests.txt)
suspects=$(times "$log" | awk -v limit="$limit" '$1 > limit { print $2 }' | grep -vxF "$known" || true)

status=0
for test in $suspects; do
  said=$(ctest --preset "$preset" --no-tests=error -R "^${test//./\\.}$" || true)
  seconds=$(sed -n 's/^Total Test time (real) = *\([0-9.]*\).*/\1/p' <<< "$said")
  if [[ ! $seconds ]]; then
    echo "ctest finds no test of the name $test." >&2
    status=1
    continue
  fi
  awk -v a="$seconds" -v limit="$limit" 'BEGIN { exit !(a > limit) }' || continue
  echo "$test takes $seconds s by itself, expected $limit at most, or a line in tests/slow_tests.txt." >&2
  status=1
done

there=$(ctest --preset "$preset" -N | sed -n 's/^ *Test *#[0-9]*: //p')
for test in $known; do
  grep -qxF -- "$test" <<< "$there" && continue
  echo "tests/slow_tests.txt names $test, which is no test." >&2
  status=1
done
exit $status
