#!/usr/bin/env bash
# Builds every fuzz target and runs each for so many seconds from its seed corpus.
#
#   scripts/fuzz.sh 600     # ten minutes each; findings and their logs in build/fuzz/found/
#
# Ends with the exit code of the first finding.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds="${1:-60}"

cmake --preset fuzz
cmake --build --preset fuzz --parallel
found="$PWD/build/fuzz/found"
for target in build/fuzz/fuzz/*_fuzz; do
  reader="$(basename "$target" _fuzz)"
  mkdir -p "$found/$reader"
  echo "$reader: $seconds s, log in build/fuzz/found/$reader.log"
  "$target" -max_total_time="$seconds" -timeout=25 -artifact_prefix="$found/$reader/" \
    "$found/$reader" "fuzz/corpus/$reader" > "$found/$reader.log" 2>&1 || {
    code=$?
    tail -n 30 "$found/$reader.log"
    exit "$code"
  }
  tail -n 1 "$found/$reader.log"
done
