#!/usr/bin/env bash
# Twelve rendered frames of a vehicle in surge in front of four markers, for the tests of fathom_track.
#
#   render.sh TOOLS LOG
set -euo pipefail
here=$(dirname "$0")
rm -rf "$2"
exec "$1/fathom_synthesize" --vehicle="$here/../../../data/vehicles/flatfish.yaml" \
  --experiment="$here/experiment.yaml" --film="$here/film.yaml" --render --out="$2"
