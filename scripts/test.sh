#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test. Says what both took.
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
echo 'Tests' && time ctest --preset "$preset" --parallel "$(nproc)"
