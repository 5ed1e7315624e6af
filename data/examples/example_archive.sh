#!/usr/bin/env bash
# Makes an archive of a vehicle that changes, to try fathom_batch on:
#
#   data/examples/example_archive.sh ARCHIVE [DIVES] [LOGS]     # 12 dives of 3 logs by default
#
# From 40 % of the dives on the vehicle carries 14 kg more. Its damping grows by 1 % a dive. From
# 70 % of them on its port thruster gives 20 % less than commanded. The logs hold the thrusts of the
# thrusters. In surge a controller holds the heading, and so gives port more to do from then on.
#
# QUIET=1: nothing changes. SEED: another draw of the noise (1). The same arguments give the
# same bytes. fathom_synthesize is found on the PATH.
set -euo pipefail
if [[ $# -lt 1 || $# -gt 3 ]]; then
  sed -n '2,12p' "$0" >&2
  exit 1
fi
archive=$(realpath -m "$1") dives=${2:-12} logs=${3:-3}
data=$(dirname "$(realpath "$0")")/..
[[ ! -e $archive ]] || { echo "$0: $archive is there already" >&2; exit 1; }
vehicles=$(mktemp -d)
trap 'rm -rf "$vehicles"' EXIT

mkdir -p "$archive"
cp "$data/vehicles/survey_rov.yaml" "$archive/vehicle.yaml"
echo 'vehicle: vehicle.yaml' > "$archive/archive.yaml"

# A thruster that gives too little acts like a vehicle with all parameters larger. In yaw port makes
# 0.45 / (0.45 + 0.30) = 0.6 of the moment. Under a held heading the moments of port and starboard
# cancel: port makes 1 / (1 + 0.45 / 0.30 * what it gives) of the commanded surge force.
vehicle_of_dive() {
  awk -v dive="$1" -v dives="$dives" -v quiet="${QUIET:-0}" '
    function number(name) { match($0, name ": [-0-9.]+"); return substr($0, RSTART + length(name) + 2, RLENGTH - length(name) - 2) }
    /inertia:/ {
      dof = $1
      load = !quiet && dive >= int(0.4 * dives) + 1 && dof != "yaw:" ? 14 : 0
      growth = quiet ? 1 : 1 + 0.01 * (dive - 1)
      weaker = !quiet && dive >= int(0.7 * dives) + 1 ? 0.2 : 0
      share = dof == "surge:" ? 1 / (1 + 1.5 * (1 - weaker)) : dof == "yaw:" ? 0.6 : 0
      scale = 1 / (1 - weaker * share)
      printf "  %s {inertia: %.6g, quadratic_damping: %.6g, linear_damping: %.6g, buoyancy: %.6g}\n", dof,
        scale * (number("inertia") + load), scale * growth * number("quadratic_damping"),
        scale * growth * number("linear_damping"), scale * number("buoyancy")
      next
    }
    { print }' "$data/vehicles/survey_rov.yaml"
}

# Turns a log's forces into the thrusts that make them: port, starboard, fore, aft.
to_thrusters() {
  local log=$1 dof=$2 dive=$3
  awk -F, -v OFS=, -v OFMT=%.12g -v CONVFMT=%.12g -v dof="$dof" -v dive="$dive" -v dives="$dives" -v quiet="${QUIET:-0}" '
    NR == 1 { print "t,thruster_1,thruster_2,thruster_3,thruster_4"; next }
    dof == "surge" {
      weaker = !quiet && dive >= int(0.7 * dives) + 1 ? 0.2 : 0
      port = $2 / (1 + 1.5 * (1 - weaker))
      print $1, port, $2 - port, 0, 0
    }
    dof == "heave" { print $1, 0, 0, $2 / 2, $2 / 2 }
    dof == "yaw" { print $1, $2 / 0.75, -$2 / 0.75, 0, 0 }' "$log/command.csv" > "$vehicles/command.csv"
  mv "$vehicles/command.csv" "$log/command.csv"
  sed -i '/^vehicle:/d' "$log/log.yaml"
  printf 'vehicle: ../../vehicle.yaml\nthruster_unit: N\n' >> "$log/log.yaml"
}

dofs=(surge heave yaw)
for ((dive = 1; dive <= dives; ++dive)); do
  vehicle_of_dive "$dive" > "$vehicles/$dive.yaml"
  for ((log = 1; log <= logs; ++log)); do
    dof=${dofs[(log - 1) % 3]}
    folder=$archive/$(printf 'dive_%02d/%02d_%s' "$dive" "$log" "$dof")
    fathom_synthesize --vehicle="$vehicles/$dive.yaml" --experiment="$data/experiments/archive_$dof.yaml" \
      --seed=$((100000 * (${SEED:-1} - 1) + 1000 * dive + log)) --out="$folder" > /dev/null
    to_thrusters "$folder" "$dof" "$dive"
  done
done
