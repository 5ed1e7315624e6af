#!/usr/bin/env bash
# Installs what is missing, builds the tools and runs them on the bundled log: compares all families
# on three degrees of freedom, then fits one model and simulates it. Then hides a dead zone of the
# thrusters in a synthetic log and diagnoses that. In the end reprocesses an archive of 12 dives in
# which the vehicle changes.
set -euo pipefail
cd "$(dirname "$0")/.."

log=data/flatfish
out=build/demo
bin=build/release/tools

scripts/install_dependencies.sh
cmake --preset release
cmake --build --preset release --parallel "$(nproc)" --target \
  tool_compare tool_identify tool_simulate tool_synthesize tool_diagnose tool_batch
mkdir -p "$out"

run() {
  printf '\n$ %s\n' "$*"
  "$@"
}
run $bin/fathom_compare --log=$log --dofs=surge,heave,yaw \
  --json=$out/flatfish.json --report=$out/flatfish.html
run $bin/fathom_identify --log=$log --dof=surge --model=$out/surge.json
run $bin/fathom_simulate --model=$out/surge.json --log=$log --out=$out/surge_prediction.csv
run $bin/fathom_synthesize --vehicle=data/vehicles/flatfish.yaml --experiment=data/experiments/surge_multisine.yaml \
  --seed=1 --effects=thrust_dead_zone:width=8 --out=$out/surge_dead_zone --overwrite
run $bin/fathom_diagnose --log=$out/surge_dead_zone --dof=surge --verdict=$out/dead_zone.json --report=$out/dead_zone.html

rm -rf "$out/dives" "$out/dives.sqlite"
run env PATH="$PWD/$bin:$PATH" data/examples/example_archive.sh "$out/dives"
run $bin/fathom_batch --archive=$out/dives --results=$out/dives.sqlite --report=$out/dives.html \
  --pages --jobs="$(nproc)"

printf '\nPages for any browser:\n  %s\n  %s\n  %s\n' "$PWD/$out/flatfish.html" "$PWD/$out/dead_zone.html" \
  "$PWD/$out/dives.html"
