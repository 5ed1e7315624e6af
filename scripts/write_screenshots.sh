#!/usr/bin/env bash
# Writes docs/images/pages: each page as people see it, at 1400, 800 and 390 px, in the dark and on
# paper. Look at them after a change of the pages.
#
#   scripts/write_screenshots.sh [--tools=build/release/tools] [PAGE ...]     # compare, diagnose, ...
set -euo pipefail
root=$(realpath "$(dirname "$0")/..")
tools=$root/build/release/tools
pages=()
for argument in "$@"; do
  case $argument in
    --tools=*) tools=$(realpath "${argument#--tools=}") ;;
    -*) sed -n '5p' "$0" >&2; exit 1 ;;
    *) pages+=("$argument") ;;
  esac
done
[[ ${#pages[@]} -gt 0 ]] || pages=(compare diagnose refine archive check check_logs)
[[ -x $tools/fathom_compare ]] || { echo "$0: there are no programs in $tools: build them, or say --tools=..." >&2; exit 1; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
ln -s "$root/data" data
export SOURCE_DATE_EPOCH=1780000000  # the date that the pages show

page_of_compare() { "$tools/fathom_compare" --log=data/flatfish --dofs=surge,heave,yaw --report="$1"; }

page_of_diagnose() {
  "$tools/fathom_synthesize" --vehicle=data/vehicles/flatfish.yaml --experiment=data/experiments/surge_multisine.yaml \
    --seed=1 --effects=thrust_dead_zone:width=8 --out=surge_dead_zone
  "$tools/fathom_diagnose" --log=surge_dead_zone --dof=surge --report="$1"
}

page_of_refine() {
  "$tools/fathom_synthesize" --vehicle=data/vehicles/flatfish.yaml --experiment=data/experiments/film_surge.yaml \
    --film=data/films/wall.yaml --seed=1 --out=filmed
  "$tools/fathom_refine" --log=filmed --dof=surge --report="$1"
}

page_of_archive() {
  PATH=$tools:$PATH "$root/data/examples/example_archive.sh" dives
  "$tools/fathom_batch" --archive=dives --results=dives.sqlite --report="$1" --diagnose=false --families=output_error
}

# Half a minute of a sensor that is stuck.
page_of_check() {
  cp -rL data/flatfish flatfish
  chmod -R u+w flatfish
  awk -F, -v OFS=, '$1 >= 100 && $1 < 130 && NR > 1 { if (!held) held = $2; $2 = held } { print }' \
    flatfish/velocity.csv > velocity.csv
  mv velocity.csv flatfish
  "$tools/fathom_check" --log=flatfish --dof=surge --report="$1" || [[ $? -eq 2 ]]
}

page_of_check_logs() {
  for seed in 1 2 3; do
    "$tools/fathom_synthesize" --vehicle=data/vehicles/flatfish.yaml --seed=$seed --out=run_$seed \
      --experiment=data/experiments/"$([[ $seed == 3 ]] && echo steps || echo multisine)".yaml
  done
  "$tools/fathom_check" --log=run_1 --log=run_2 --log=run_3 --report="$1" || [[ $? -eq 2 ]]
}

for page in "${pages[@]}"; do
  echo "$page" >&2
  "page_of_$page" "$page.html" > "$page.txt" || { cat "$page.txt" >&2; exit 1; }
  for look in "1400 1000 light" "800 1000 light" "390 844 light" "1400 1000 dark" "718 1000 print"; do
    read -r width height kind <<< "$look"
    name=$width
    [[ $kind == light ]] || name=$kind
    mkdir -p "$root/docs/images/pages"
    "$root/scripts/screenshot.sh" "$page.html" "$root/docs/images/pages/${page}_$name.png" "$width" "$height" "$kind"
  done
done
