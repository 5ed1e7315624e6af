#!/usr/bin/env bash
# Writes into README.md and docs/ what the programs say, so that no page shows what they no longer do:
#
#   scripts/write_docs.sh [--check] [--tools=build/release/tools] [PAGE ...]
#
# --check writes nothing. It prints what differs, and then ends with exit code 1.
#
# A page says in comments, which a reader does not see, what is run and what of it is shown:
#
#   <!-- run -->                  The indented commands that follow are run, in a folder of the page.
#   <!-- run: COMMANDS -->        Commands that the page does not show.
#   <!-- shows: FILTER -->        What the last run printed, through one of the filters below,
#   <!-- end -->                  stands between these two.
#   <!-- picture: COMMANDS = N --> The commands write the picture that follows, $picture. N is the
#                                 checksum of what the last run printed: another one, and the picture
#                                 is old.
#
# `run on real data` needs the logs in FATHOM_REALDATA (../shared/realdata). Where they are not, it and
# what is shown of it stay as they are. `run by hand` is not run: it takes too long.
set -euo pipefail
export LC_ALL=C.UTF-8

root=$(realpath "$(dirname "$0")/..")
tools=$root/build/release/tools
check=
pages=()
for argument in "$@"; do
  case $argument in
    --check) check=1 ;;
    --tools=*) tools=$(realpath "${argument#--tools=}") ;;
    -*) sed -n '2,6p' "$0" >&2; exit 1 ;;
    *) pages+=("$(realpath "$argument")") ;;
  esac
done
cd "$root"
real=$(realpath -m "${FATHOM_REALDATA:-$root/../shared/realdata}")
if [[ ${#pages[@]} -eq 0 ]]; then
  mapfile -t pages < <(grep -lE '^<!-- run( on real data)?(: .*)? -->$' "$root"/docs/*.md "$root/README.md")
fi
[[ -x $tools/fathom_diagnose ]] || {
  echo "$0: there are no programs in $tools; build them, or give --tools" >&2
  exit 1
}
export PATH=$tools:$root/scripts:$PATH

# --- Filters: from what the last run printed to lines of a page.

# Lines of at most 100 characters, each behind a prefix.
wrapped() {
  local prefix=$1 line= word
  for word in $(cat); do
    if [[ -n $line && $((${#prefix} + ${#line} + 1 + ${#word})) -gt 100 ]]; then
      printf '%s%s\n' "$prefix" "$line"
      line=
    fi
    line+=${line:+ }$word
  done
  printf '%s%s\n' "$prefix" "$line"
}

code() { sed -e 's/^/    /' -e 's/ *$//'; }

# The sentence of fathom_diagnose.
sentence() { sed -n 2p | wrapped '> '; }

# The blocks between empty lines with these numbers, or to the last: "2,3", "4,$".
blocks() {
  awk -v wanted="$1" 'BEGIN { split(wanted, ends, ","); from = ends[1]; to = ends[2] == "" ? from : ends[2]; n = 1 }
    /^$/ { ++n; empty = 1; next }
    n >= from && (to == "$" || n <= to) { if (empty && any) print ""; print; any = 1; empty = 0 }' | code
}

# The lines that a pattern of grep finds.
lines() { grep -E -- "$1" | code; }

# The lines that a pattern of grep finds, as a quotation.
quoted() { grep -E -- "$1" | sed 's/^/> /'; }

# The note or the warning that a pattern finds, as a quotation.
note() { grep -E -- "$1" | head -1 | sed -E 's/^(note|next|WARNING): //' | wrapped '> '; }

# A table of fathom_diagnose over six draws of an experiment in which an effect is hidden; `shown` is
# a parameter of the model, `truth` its value, and `of_effect` the parameter of the effect.
six_draws() {
  local experiment=$1 effect=$2 shown=$3 truth=$4 of_effect=$5 seed
  for seed in 1 2 3 4 5 6; do
    fathom_synthesize --vehicle=data/vehicles/flatfish.yaml --experiment="data/experiments/$experiment.yaml" \
      --seed="$seed" --effects="$effect" --out="draw_$seed" > /dev/null
    echo "seed $seed"
    fathom_diagnose --log="draw_$seed" --dof=surge
  done | awk -v shown="$shown" -v truth="$truth" -v of_effect="$of_effect" '
    function row() {
      if (seed) printf "| %s | %s | %s | %s | %s | %s | %s to %s |\n", seed, verdict, before, after, off, value, was, is
    }
    $1 == "seed" { row(); seed = $2; verdict = before = after = off = value = was = is = "-" }
    /^surge: / { verdict = $2 }
    $1 == shown {
      unit = $2
      $1 = $2 = ""
      n = split($0, f)
      before = f[1] " ± " f[3]; after = f[4] " ± " f[6]
      off = sprintf("%+.1f %%", 100 * (f[4] - truth) / truth)
    }
    index($1, "." of_effect) { effect_unit = $2; value = $4 " ± " $6 }
    /NMAE, held-out data/ { was = sprintf("%.3f", $5); is = sprintf("%.3f", $6) }
    END { row(); print "units", unit, effect_unit }' > draws.txt
  local units
  read -r _ unit effect_unit < <(tail -1 draws.txt)
  local name=${shown//_/ } effect_name=${of_effect//_/ }
  echo "| seed | verdict | baseline: $name $unit | extended: $name $unit | off by | $effect_name $effect_unit | held-out NMAE |"
  echo '| --- | --- | --- | --- | --- | --- | --- |'
  sed '$d' draws.txt
}

# The models of fathom_compare on lbv_surge, and those of its author (reference.json beside the log).
lbv_surge_models() {
  echo '| model | inertia [kg] | linear damping [kg/s] | NMAE on held-out data |'
  echo '| --- | --- | --- | --- |'
  compared_models
  author_model "the author's adaptive law" 14.874439 0.479508 4.346772 -0.023562
  author_model "the author's least squares" 12.680732 0.242507 3.607200 -0.006061
}

# The rows of fathom_compare with the inertia, the linear damping and the error on held-out data.
compared_models() {
  awk '/velocity.csv|camera/ && !/^note/ {
      gsub(/± +/, "± "); sub(/^[* ] +/, "")
      split($0, f, /  +/)
      printf "| %s | %s | %s | %.3f |\n", f[2], f[3], f[5], f[10]
    }'
}

# NAME INERTIA QUADRATIC LINEAR BUOYANCY: such a row of a model of lbv_surge by its author, with its
# command as logged and as he shifted it.
author_model() {
  local shift held_out=()
  cat > author.json << END
{"schema": "fathom-model-1", "dof": "surge", "structure": {"baseline": "uncoupled", "effects": []}, "force_unit": "N",
 "parameters": {"inertia": {"value": $2, "std": null, "unit": "kg"}, "quadratic_damping": {"value": $3, "std": null, "unit": "kg/m"},
                "linear_damping": {"value": $4, "std": null, "unit": "kg/s"}, "buoyancy": {"value": $5, "std": null, "unit": "N"}}}
END
  for shift in 0 2.2; do
    rm -rf shifted && cp -rL lbv_surge shifted
    awk -F, -v OFS=, -v shift="$shift" 'NR > 1 { $1 = sprintf("%.6f", $1 + shift) } 1' \
      lbv_surge/command.csv > shifted/command.csv
    held_out+=("$(fathom_simulate --model=author.json --log=shifted --velocity=author_velocity.csv |
      sed -n 's/^surge, held out: .*velocity NMAE \([0-9.]*\) .*/\1/p')")
  done
  LC_ALL=C printf '| %s | %.2f | %.2f | %.3f (%.3f with his shift of 2.2 s) |\n' "$1" "$2" "$4" "${held_out[@]}"
}

# The numbers and texts of a JSON file that Fathom wrote, one a line: "causes.0.delta_bic 278.1".
values_of() {
  awk '{
      match($0, /[^ ]/); depth = (RSTART - 1) / 2; value = substr($0, RSTART); sub(/,$/, "", value)
      if (value ~ /^[]}]/) next
      if (value ~ /^"[^"]*": /) {
        key = value; sub(/^"/, "", key); sub(/": .*/, "", key); sub(/^"[^"]*": /, "", value)
      } else {
        key = item[depth]++
      }
      path[depth] = key; item[depth + 1] = 0
      if (value ~ /^[[{]$/) next
      name = path[1]
      for (i = 2; i <= depth; ++i) name = name "." path[i]
      print name, value
    }' "$1"
}

# The verdict file verdict.json, shortened: each @path@ is the value of that path, of a number four digits.
verdict_example() {
  values_of verdict.json > values.txt
  awk 'NR == FNR { path = $1; sub(/^[^ ]+ /, ""); values[path] = $0; next }
    {
      while (match($0, /@[a-z_0-9.]+@/)) {
        path = substr($0, RSTART + 1, RLENGTH - 2)
        before = substr($0, 1, RSTART - 1); after = substr($0, RSTART + RLENGTH)
        if (!(path in values)) { print "verdict.json has no " path > "/dev/stderr"; exit 1 }
        value = values[path]
        if (value ~ /^-?[0-9]/) value = sprintf("%.4g", value)
        if (length(value) > 70) value = substr(value, 1, index(value, ",")) " ...\""
        $0 = before value after
      }
      print
    }' values.txt - << 'END' | code
{"schema": @schema@, "log": @log@, "dof": @dof@, "verdict": @verdict@,
 "sentence": @sentence@, "force_unit": @force_unit@,
 "figures_of": @figures_of@, "has_baseline": @has_baseline@,
 "baseline": {"parameters": {"inertia": {"value": @baseline.parameters.inertia.value@, "std": @baseline.parameters.inertia.std@, "unit": @baseline.parameters.inertia.unit@}, ...},
              "mae": @baseline.mae@, "nmae": @baseline.nmae@, "n": @baseline.n@, "duration": @baseline.duration@, "heldout_mae": @baseline.heldout_mae@, "heldout_nmae": @baseline.heldout_nmae@,
              "structure": {...}, "covariance": [[...], ...], "log_likelihood": @baseline.log_likelihood@,
              "speed_range": [@baseline.speed_range.0@, @baseline.speed_range.1@], "force_range": [@baseline.force_range.0@, @baseline.force_range.1@]},
 "causes": [{"effect": @causes.0.effect@, "place": @causes.0.place@, "reference_force": @causes.0.reference_force@,
             "parameters": {"width": {"value": @causes.0.parameters.width.value@, "std": @causes.0.parameters.width.std@, "unit": @causes.0.parameters.width.unit@}},
             "p_value": @causes.0.p_value@, "delta_bic": @causes.0.delta_bic@, "heldout_gain": @causes.0.heldout_gain@, "alternatives": @causes.0.alternatives@, "experiment": @causes.0.experiment@,
             "scope": @causes.0.scope@, "because": @causes.0.because@, "advice": "Look for the dead band ..."}],
 "extended": {"parameters": {"inertia": {...}, ..., "thrust_dead_zone.width": {...}}, "mae": @extended.mae@, ...},
 "findings": @findings@, "explained_share": @explained_share@, "remaining_p_value": @remaining_p_value@,
 "heldout_gain": {"value": @heldout_gain.value@, "low": @heldout_gain.low@, "high": @heldout_gain.high@, "is_in_poses": @heldout_gain.is_in_poses@, "by_left_out_blocks": @heldout_gain.by_left_out_blocks@},
 "candidates": [..., {"effect": @candidates.1.effect@, "place": @candidates.1.place@, "label": @candidates.1.label@,
                      "parameters": {"exponent": {...}}, "score": @candidates.1.score@, "gain": @candidates.1.gain@, "delta_bic": @candidates.1.delta_bic@,
                      "p_value": @candidates.1.p_value@, "kept": @candidates.1.kept@, "why": "dropped: helps alone, ..."}, ...],
 "limits": [...], "coincidence": @coincidence@, "logs": [@logs.0@], "log_fingerprints": ["..."], "remarks": @remarks@}
END
}

# --- One page.

# Runs the commands of standard input, one a line, and keeps what the last one printed.
run_commands() {
  local command  # read without -r joins lines that end in a backslash
  while IFS= read command; do
    [[ -n $command ]] || continue
    ( eval "$command" ) > shown.txt 2> err.txt < /dev/null || {
      printf '%s: this command failed:\n%s\n' "$page_name" "$command" >&2
      tail -5 err.txt >&2
      return 1
    }
  done
}

# The page on standard input with its blocks written anew.
write_page() {
  local line kind=run is_skipped= commands filter sum
  while IFS= read -r line || [[ -n $line ]]; do
    if [[ $line =~ ^'<!-- run'(' on real data'|' by hand')?(': '(.*))?' -->'$ ]]; then
      kind=${BASH_REMATCH[1]} commands=${BASH_REMATCH[3]}
      printf '%s\n' "$line"
      if [[ -z $commands ]]; then
        while IFS= read -r line && [[ $line == '    '* || -z $line && -z $commands ]]; do
          printf '%s\n' "$line"
          commands+=${line#    }$'\n'
        done
        printf '%s\n' "$line"
      fi
      is_skipped=
      if [[ $kind == ' by hand' ]]; then
        is_skipped=1
      elif [[ $kind == ' on real data' && ! -d $real ]]; then
        is_skipped=1
        echo "$page_name: what rests on the logs of others is not looked at: there is no $real" >&2
      else
        run_commands <<< "$commands" || return 1
      fi
    elif [[ $line =~ ^'<!-- shows: '(.*)' -->'$ ]]; then
      filter=${BASH_REMATCH[1]}
      printf '%s\n' "$line"
      if [[ -z $is_skipped ]]; then
        eval "$filter" < shown.txt > block.txt 2> err.txt && [[ -s block.txt ]] || {
          echo "$page_name: '$filter' finds nothing in what was run" >&2
          return 1
        }
        cat block.txt
      fi
      while IFS= read -r line && [[ $line != '<!-- end -->' ]]; do
        [[ -z $is_skipped ]] || printf '%s\n' "$line"
      done
      [[ $line == '<!-- end -->' ]] || { echo "$page_name: <!-- end --> is missing" >&2; return 1; }
      printf '%s\n' "$line"
    elif [[ $line =~ ^'<!-- picture: '(.*)' = '([0-9]*)' -->'$ ]]; then
      commands=${BASH_REMATCH[1]} sum=${BASH_REMATCH[2]}
      IFS= read -r line
      [[ $line =~ \]\((.*)\)$ ]] || { echo "$page_name: no picture behind its comment" >&2; return 1; }
      picture=$page_folder/${BASH_REMATCH[1]}
      if [[ -z $is_skipped ]]; then
        local now
        now=$(cksum < shown.txt | cut -d' ' -f1)
        if [[ -z $check && ( $now != "$sum" || ! -s $picture ) ]]; then
          ( eval "$commands" ) > /dev/null 2> err.txt || { tail -5 err.txt >&2; return 1; }
        fi
        sum=$now
      fi
      printf '<!-- picture: %s = %s -->\n%s\n' "$commands" "$sum" "$line"
    else
      printf '%s\n' "$line"
    fi
  done
}

# Writes or checks one page, in a folder of its own where data and the real logs can be read.
do_page() {
  local page=$1 folder differs=0
  page_name=${page#"$root"/} page_folder=$(dirname "$page")
  folder=$(mktemp -d)
  (
    cd "$folder"
    ln -s "$root/data" "$root/docs" .
    mkdir scripts && ln -s "$root"/scripts/*.sh scripts
    if [[ -d $real ]]; then ln -s "$real"/*/ .; fi
    write_page < "$page" > page.md
  ) || { rm -rf "$folder"; return 1; }
  if [[ -n $check ]]; then
    diff -u --label "$page_name" --label "$page_name, as the programs say it" "$page" "$folder/page.md" || differs=1
  elif ! cmp -s "$page" "$folder/page.md"; then
    cat "$folder/page.md" > "$page"
    echo "$page_name: written"
  fi
  rm -rf "$folder"
  return $differs
}

# As many pages at a time as there are cores.
result=0
for page in "${pages[@]}"; do
  if [[ $page == "$root/README.md" ]]; then  # quotes other pages
    while [[ -n $(jobs -rp) ]]; do wait -n || result=1; done
  fi
  while [[ $(jobs -rp | wc -l) -ge $(nproc) ]]; do wait -n || result=1; done
  do_page "$page" &
done
while [[ -n $(jobs -p) ]]; do
  wait -n || result=1
  jobs > /dev/null
done
if [[ -n $check && $result -ne 0 ]]; then echo "Write the pages anew: scripts/write_docs.sh" >&2; fi
exit $result
