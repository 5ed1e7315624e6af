#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test.
#
#   scripts/test.sh          optimised, with debug information (preset dev)
#   scripts/test.sh asan     under the address and undefined behaviour sanitizers
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:-dev}
scripts/install_dependencies.sh
cmake --preset "$preset"
cmake --build --preset "$preset" --parallel "$(nproc)"
ctest --preset "$preset" --parallel "$(nproc)"
