#!/usr/bin/env bash
# Installs what is missing, builds the tools and runs them on the bundled log: compares all families
# on three degrees of freedom, then fits one model and simulates it.
set -euo pipefail
cd "$(dirname "$0")/.."

log=data/flatfish
out=build/demo
bin=build/release/tools

scripts/install_dependencies.sh
cmake --preset release
cmake --build --preset release --parallel "$(nproc)" --target tools
mkdir -p "$out"

run() {
  printf '\n$ %s\n' "$*"
  "$@"
}
run $bin/fathom_compare --log=$log --dofs=surge,heave,yaw \
  --json=$out/flatfish.json --report=$out/flatfish.html
run $bin/fathom_identify --log=$log --dof=surge --model=$out/surge.json
run $bin/fathom_simulate --model=$out/surge.json --log=$log --out=$out/surge_prediction.csv

printf '\nThe comparison, as a page for any browser: %s\n' "$PWD/$out/flatfish.html"
