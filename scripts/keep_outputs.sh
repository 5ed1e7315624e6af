#!/usr/bin/env bash
# Runs every tool on data/, on ten hidden logs and on the real logs, and keeps all that it says and
# writes, to compare two builds by:
#
#   scripts/keep_outputs.sh build/before /tmp/before
#   scripts/keep_outputs.sh build/dev /tmp/after
#   diff -r /tmp/before /tmp/after
#
# Each case has a folder with its files, out.txt, err.txt and exit_code.txt. What no build writes
# twice alike (films, the seconds that a search took) is left out. KEEP_OUTPUTS_JOBS: cases at a
# time (all cores); KEEP_OUTPUTS_ONLY: a pattern of case names (grep -E). The real logs are looked
# for in FATHOM_REALDATA (../shared/realdata).
set -uo pipefail
if [[ $# -ne 2 ]]; then
  sed -n '2,13p' "$0" >&2
  exit 1
fi
build=$(realpath "$1") results=$(realpath -m "$2")
cd "$(dirname "$0")/.."
data=$PWD/data
real=$(realpath -m "${FATHOM_REALDATA:-../shared/realdata}")
mkdir -p "$results"
[[ -z $(ls -A "$results") ]] || { echo "$0: $results is not empty" >&2; exit 1; }
cases=$(mktemp)
trap 'rm -f "$cases"' EXIT

# add NAME COMMAND: a case; its command runs in a folder of that name.
add() {
  if grep -qE "${KEEP_OUTPUTS_ONLY:-.}" <<< "$1"; then printf '%s\t%s\n' "$1" "$2" >> "$cases"; fi
}

# Logs by the tools themselves.
flatfish=$data/vehicles/flatfish.yaml
mkdir -p "$results/logs/hidden"
cd "$results/logs"
ln -s "$data" "$results/data"
[[ -d $real ]] && ln -s "$real" "$results/real"
PATH=$build/tools:$PATH
run() { "$@" > /dev/null 2>> errors.txt || echo "$0: $* gave $?" >&2; }
for experiment in steps surge_multisine table1 pilot yaw_prbs; do
  run fathom_synthesize --vehicle="$flatfish" --experiment="$data/experiments/$experiment.yaml" --seed=1 \
    --out="$experiment" --truth="$experiment.truth.json"
done
run fathom_synthesize --vehicle="$flatfish" --experiment="$data/experiments/surge_multisine.yaml" --seed=1 \
  --effects=thrust_dead_zone:width=8 --out=dead_zone --truth=dead_zone.truth.json
run fathom_synthesize --vehicle="$flatfish" --experiment="$data/experiments/surge_multisine.yaml" --seed=2 \
  --effects=thruster_lag:time_constant=0.5,sensor_bias --out=lag_and_bias --truth=lag_and_bias.truth.json
for dof in surge heave yaw; do
  run fathom_synthesize --vehicle="$flatfish" --experiment="$data/experiments/film_$dof.yaml" \
    --film="$data/films/wall.yaml" --out="film_$dof" --truth="film_$dof.truth.json"
done
"$build/tests/hidden/hidden_scores" --save=hidden > hidden.txt 2>> errors.txt \
  --only=nothing.3,thrust_dead_zone.1,thruster_lag.0,coulomb_friction.2,time_offset.3,buoyancy_step.4,velocity_coupling.5,sensor_clock_offset.6,thrust_saturation.2,unlisted.place_bump.5

for log in flatfish; do
  for family in least_squares adaptive output_error; do
    add "identify_$family" "fathom_identify --log=../data/$log --dof=surge --family=$family --model=model.json"
  done
  add compare_flatfish "fathom_compare --log=../data/$log --dofs=surge,heave,yaw --json=rows.json --report=page.html"
  add simulate_flatfish "fathom_identify --log=../data/$log --dof=surge --model=model.json; fathom_simulate --model=model.json --log=../data/$log --out=prediction.csv"
  add diagnose_flatfish "fathom_diagnose --log=../data/$log --dof=surge --verdict=verdict.json --report=page.html"
done
for log in steps pilot; do
  add "compare_$log" "fathom_compare --log=../logs/$log --json=rows.json --report=page.html"
done
add diagnose_yaw_prbs "fathom_diagnose --log=../logs/yaw_prbs --dof=yaw --verdict=verdict.json --report=page.html"
add identify_camera_steps "fathom_identify --log=../logs/steps --dof=surge --source=camera --model=model.json"
for log in dead_zone lag_and_bias; do
  add "diagnose_$log" "fathom_diagnose --log=../logs/$log --dof=surge --verdict=verdict.json --report=page.html; \
fathom_simulate --model=verdict.json --log=../data/flatfish --out=prediction.csv; \
fathom_simulate --model=verdict.json --log=../logs/$log --out=own_prediction.csv --keep_run_effects"
done
add diagnose_two_logs "fathom_diagnose --log=../logs/dead_zone --log=../logs/surge_multisine --dof=surge --verdict=verdict.json --report=page.html"
for dof in surge heave yaw; do
  add "track_film_$dof" "fathom_track --log=../logs/film_$dof --out=tracked --summary=summary.json; \
fathom_simulate --model=../identify_output_error/none.json --log=tracked"
  add "refine_film_$dof" "fathom_refine --log=../logs/film_$dof --dof=$dof --json=rows.json --model=model.json --trajectory=refined.csv --report=page.html"
  add "identify_film_$dof" "fathom_identify --log=../logs/film_$dof --dof=$dof --family=joint --model=model.json"
  add "diagnose_film_$dof" "fathom_diagnose --log=../logs/film_$dof --dof=$dof --verdict=verdict.json --report=page.html"
done
for log in logs/hidden/*/ hidden/*/; do
  [[ -d $log ]] || continue
  name=$(basename "$log")
  dof=$(sed -n 's/^dof: *\[\{0,1\}\([a-z]*\).*/\1/p' "$log/log.yaml" | head -1)
  add "hidden_$name" "fathom_identify --log=../logs/hidden/$name --dof=$dof --model=model.json; fathom_diagnose --log=../logs/hidden/$name --dof=$dof --verdict=verdict.json --report=page.html"
done
if [[ -d $real ]]; then
  for log in lbv_surge:surge lbv_surge_short:surge lbv_yaw:yaw pool_rov_surge:surge emps_pulses_velocity:surge \
             emps_pulses_pose:surge silverbox_small:surge kingfisher_runs/run_01:surge kingfisher_runs/run_01:yaw \
             kingfisher_runs/run_13:surge dc_motor_stairs:yaw hsm150_runs/neg_0.045_1:yaw hsm150_runs/pos_0.06_2:yaw \
             auv_6dof/surge_1:surge auv_6dof/yaw_1:yaw boat_archive/run_001:surge; do
    dof=${log#*:} folder=${log%:*}
    name=${folder//\//_}_$dof
    add "real_compare_$name" "fathom_compare --log=../real/$folder --dofs=$dof --json=rows.json --report=page.html; fathom_identify --log=../real/$folder --dof=$dof --model=model.json; fathom_simulate --model=model.json --log=../real/$folder --out=prediction.csv"
    add "real_diagnose_$name" "fathom_diagnose --log=../real/$folder --dof=$dof --verdict=verdict.json --report=page.html"
  done
  add real_diagnose_author "fathom_diagnose --log=../real/lbv_surge --dof=surge --velocity=author_velocity.csv --verdict=verdict.json"
  add real_track_tag_video "fathom_track --log=../real/tag_video --out=tracked --summary=summary.json"
  for log in heave_a surge_sine; do
    add "real_refine_$log" "fathom_refine --log=../real/camera_by_others/$log --json=rows.json --model=model.json --trajectory=refined.csv --report=page.html"
  done
fi
for tool in identify compare simulate synthesize track refine diagnose; do
  add "help_$tool" "fathom_$tool --help"
done
add refusals "fathom_identify --log=nothing; fathom_compare --log=../data/flatfish --dofs=roll; fathom_diagnose --log=../data/flatfish --dof=surge --seed=x; \
fathom_simulate --model=none.json --log=../data/flatfish; fathom_synthesize --vehicle=$flatfish; fathom_track --log=../data/flatfish; fathom_refine --log=../data/flatfish --dof=surge"

export KEEP_RESULTS=$results
run_case() {
  local name=${1%%$'\t'*} command=${1#*$'\t'}
  mkdir -p "$KEEP_RESULTS/$name" && cd "$KEEP_RESULTS/$name" || exit
  local from=$SECONDS
  bash -c "$command" > out.txt 2> err.txt < /dev/null
  echo $? > exit_code.txt
  echo "$((SECONDS - from)) s $name" >> "$KEEP_RESULTS/../$(basename "$KEEP_RESULTS").times"
}
export -f run_case
cd "$results"
xargs -d '\n' -a "$cases" -P "${KEEP_OUTPUTS_JOBS:-$(nproc)}" -I{} bash -c 'run_case "$1"' _ {}
rm -f "$results/data" "$results/real"
echo "$(wc -l < "$results/../$(basename "$results").times") cases in $results" >&2
