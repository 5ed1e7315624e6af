#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test. Says what both took, and which
# tests were the slowest; fails for one that takes over 10 s and is none of tests/slow_tests.txt.
#
#   scripts/test.sh          optimised, with debug information (preset dev)
#   scripts/test.sh asan     under the address and undefined behaviour sanitizers
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:-dev}
TIMEFORMAT='CPU seconds: %U user, %S system; %R elapsed'
scripts/install_dependencies.sh
cmake --preset "$preset"
echo 'Build' && time cmake --build --preset "$preset" --parallel "$(nproc)"
# One more than there are cores: many tests wait for programs and disks.
echo 'Tests' && time ctest --preset "$preset" --parallel "$(($(nproc) + 1))"

echo 'The slowest tests [s]'
awk '/^[0-9]+\/[0-9]+ Testing: / { sub(/^[^:]*: /, ""); name = $0 }
     /^Test time =/ { print $4, name }' "build/$preset/Testing/Temporary/LastTest.log" |
  sort -rn | sed -n 1,20p
scripts/check_test_times.sh "$preset"
