#!/usr/bin/env bash
# The main job: set up, build, fetch, run, check, plot. See --help.
set -euo pipefail

program=run_all.sh
root=$(unset CDPATH; cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
# shellcheck source=tools/common.sh
source "$root/tools/common.sh"

all_steps=(build fetch run check plot)
known_steps=(build peers fetch run check plot)
presets=(release ci)
preset=release
corpus=standard
out=
old_run=
resumed=
peers=
solvers=
meshes=
folder=
only=
install=yes
run_options=()
adds_solvers=
steps=()
current=
check_failed=

usage() {
  cat <<EOF
Usage: ./run_all.sh [STEP...] [OPTION...]

Runs the exact geodesic solvers on a corpus of meshes and writes the thesis's tables
and figures.
Without a step it does all of these, in this order:
  build   compile the optimised solvers and the harness (build/release)
  fetch   generate or download the corpus's meshes into the dataset cache
  run     solve, verify and time every solver on every mesh
  check   fail unless every cell of the run is there and verified
  plot    write the tables and figures of the run, and a page that shows them
Only when it is named, or --peers is given:
  peers   fetch and compile the public codes of peers/
Without run, check and plot take the newest run, or the one that --run names. They solve nothing:
every table, figure and the page can be drawn again from an old run.

Options:
  --corpus NAME        meshes to run on (default: standard, that is the quick ones, and horse,
                       bunny and rocker arm where available; see geodesic-bench list)
  --solvers A,B        only these solvers
  --peers all|A,B      also these public codes: built by peers, measured by run
  --meshes A,B         these in place of the corpus: its names, mesh files, folders, quoted patterns
  --sources N          source vertices of each mesh
  --further-sources N  random vertices that each solver then solves from, one after the other
  --path-targets N     vertices to measure paths to, of solvers that have paths
  --repetitions N      timed solves of each solver, mesh and source
  --out DIR            folder that run writes (default: results/runs/<UTC time>-<corpus>)
  --folder DIR         every mesh file in this folder and below it, in place of a corpus; meshes that
                       cannot be solved are listed with a reason
  --repair             repair meshes that cannot be solved, where possible
  --external NAME=COMMAND, --plugin FILE
                       more solvers, which --solvers names (docs/external-solvers.md, docs/plugins.md)
  --cells, --source-sets, --seed, --min-time, --reference, --time-limit, --memory-limit, --vectors,
  --recordings, --threads, --frames, --interleave, --accept-changes
                       passed on to geodesic-bench run: see its --help
  --resume DIR         continue an interrupted run with its options
  --run DIR            folder of an old run, for check and plot (default: the newest)
  --only A,B           the only tables and figures that plot draws: times,speedup
                       (geodesic-bench plot --help lists all)
  --preset NAME        the build to measure: release (default), or ci (warnings are errors)
  --no-install         never install a package: print the line that would, and stop
  --help               this text

Environment:
  GEODESIC_DATASETS          dataset cache (default: datasets/cache)
  GEODESIC_DATASETS_MIRROR   folder, file:// or http:// address with a copy of the upstream
                             meshes, which fetch then takes from there
  GEODESIC_PEERS_MIRROR      the same with the Git repositories of the public codes, for peers

Missing packages are installed with apt, as root or with sudo. Log: build/logs/run_all.log
EOF
}

take_word() {
  case $1 in
    --repair | --frames | --interleave | --accept-changes) run_options+=("$1") ;;
    --preset) take_preset "$@" ;;
    --corpus) take_value "$@"; corpus=$value ;;
    --folder)
      take_value "$@"
      folder=$(absolute "$value")
      corpus=$(basename "$value" | tr -c 'A-Za-z0-9_.\n-' -)
      ;;
    --peers) take_value "$@"; peers=$value ;;
    --solvers) take_value "$@"; solvers=$value ;;
    --meshes) take_value "$@"; meshes=$value ;;
    --only) take_value "$@"; only=$value ;;
    --sources | --further-sources | --path-targets | --repetitions)
      take_number "$@"
      run_options+=("$1" "$value")
      ;;
    --external | --plugin)
      take_value "$@"
      if [[ -e $value ]]; then value=$(absolute "$value"); fi
      run_options+=("$1" "$value")
      adds_solvers=yes
      ;;
    --cells | --source-sets | --seed | --min-time | --reference | --time-limit | --memory-limit | --vectors | \
      --recordings | --threads)
      take_value "$@"
      run_options+=("$1" "$value")
      ;;
    --out) take_value "$@"; out=$(absolute "$value") ;;
    --run) take_value "$@"; old_run=$(absolute "$value") ;;
    --resume) take_value "$@"; resumed=$(absolute "$value") ;;
    -*) unknown_option "$1" ;;
    *)
      [[ " ${known_steps[*]} " == *" $1 "* ]] ||
        die "unknown step $1; steps are ${known_steps[*]}"
      steps+=("$1")
      ;;
  esac
}

# Checks combinations of options, and sets the options that follow from others.
complete_options() {
  if [[ ${#steps[@]} -eq 0 ]]; then
    steps=("${all_steps[@]}")
    if [[ -n $folder ]]; then steps=(build run check plot); fi
    if [[ -n $peers ]]; then steps+=(peers); fi
  fi
  if has_step run; then
    [[ -z $old_run ]] || die "--run is for check and plot of an old run; run writes to --out DIR"
    if [[ -n $resumed ]]; then
      [[ -z $out ]] || die "--out cannot be used with --resume, which names the folder"
      out=$resumed
    fi
  else
    [[ -z $out$resumed ]] || die "--out and --resume are for run; check and plot take --run DIR"
    out=$old_run
  fi
  [[ -z $only ]] || has_step plot || die "--only is for plot"
}

has_step() {
  [[ " ${steps[*]} " == *" $1 "* ]]
}

need_bench() {
  [[ -x $bench ]] || die "there is no $bench; run ./run_all.sh build"
}

step_build() {
  build_preset "$preset" --target geodesic-bench
}

# build_peers OPTION...: runs peers/build.py for the peers of --peers, by default all.
build_peers() {
  local names=()
  if [[ -n $peers && $peers != all ]]; then IFS=, read -ra names <<<"$peers"; fi
  "$python" "$root/peers/build.py" --bench "$bench" "$@" "${names[@]}"
}

step_peers() {
  need_bench
  logged build_peers
}

step_fetch() {
  need_bench
  local status=0 bars=()
  # Progress bars go directly to the terminal, because logged output passes through a pipe.
  if [[ -t 2 ]]; then bars=(--bars "$(tty <&2)"); fi
  logged "$python" "$root/datasets/fetch.py" --corpus "$corpus" --bench "$bench" "${bars[@]}" ||
    status=$?
  # Exit code 3: some meshes cannot be fetched. The run leaves them out and reports them.
  [[ $status -eq 0 || $status -eq 3 ]]
}

# suite_solvers FILE: prints the solvers that the suite names, separated by commas.
suite_solvers() {
  "$python" -c 'import json, sys
with open(sys.argv[1], encoding="utf-8") as file:
    print(",".join(json.load(file).get("solvers", [])))' "$1"
}

step_run() {
  need_bench
  local status=0 what=(--corpus "$corpus") where=(--out "$out") words beside=$solvers
  local suite=$root/harness/suites/$corpus.json
  if [[ -n $folder ]]; then what=(--folder "$folder"); fi
  if [[ -n $meshes ]]; then
    what=(--meshes "$meshes")
    if [[ -f $suite ]]; then what=("$suite" "${what[@]}"); fi
  fi
  if [[ -n $peers ]]; then
    if [[ -z $solvers$folder && -f $suite ]]; then beside=$(suite_solvers "$suite"); fi
    words=$(build_peers --words "$beside")
    mapfile -t -O "${#run_options[@]}" run_options <<<"$words"
  elif [[ -n $solvers ]]; then
    run_options+=(--solvers "$solvers")
  fi
  if [[ -n $resumed ]]; then
    what=()
    where=(--resume "$resumed")
  fi
  (cd "$root" && GEODESIC_COMMAND="./run_all.sh$(given_words)" \
    logged "$bench" run "${what[@]}" "${run_options[@]}" "${where[@]}") || status=$?
  # Failed cells are results, which check reports. Only an incomplete run is an error here.
  if [[ $status -ge 128 || ! -f $out/run.json ]]; then
    if [[ -f $out/request.json ]]; then say "To continue: $(printf %q "$0")$(given_words) --resume $(printf %q "$out")"; fi
    exit "$status"
  fi
}

# given_words: prints the words of this command as they were given, but --out and --resume.
given_words() {
  local word skipped=
  for word in "${given[@]}"; do
    if [[ -n $skipped ]]; then
      skipped=
    elif [[ $word == --out || $word == --resume ]]; then
      skipped=yes
    elif [[ $word != --out=* && $word != --resume=* ]]; then
      printf ' %q' "$word"
    fi
  done
}

# A failure only changes the exit code at the end, because the tables show failed cells.
step_check() {
  local accepted=()
  # A failure of a public code is a result of the comparison.
  if [[ -n $peers ]]; then accepted+=(--others-may-fail); fi
  PYTHONPATH=${PYTHONPATH:+$PYTHONPATH:}$root logged "$python" -m gate.check_run "${accepted[@]}" "$out" ||
    check_failed=yes
}

# The hundred files of a report are listed only in the log, so that the output of check stays visible.
step_plot() {
  local names
  if [[ -n $only ]]; then
    IFS=, read -ra names <<<"$only"
    PYTHONPATH=${PYTHONPATH:+$PYTHONPATH:}$root logged "$python" -m plots "${names[@]}" --run "$out"
    return
  fi
  PYTHONPATH=${PYTHONPATH:+$PYTHONPATH:}$root "$python" -m plots.report "$out" >>"$log"
}

# check_words: refuses names and folders that do not exist, before the first step.
check_words() {
  local words=()
  if has_step run && [[ -z $resumed && -e $out/run.json ]]; then
    die "$out already contains a run; remove it, or give another --out"
  fi
  if [[ -n $folder ]]; then
    words+=(--folder "$folder")
  elif has_step fetch || has_step run; then
    words+=(--corpus "$corpus")
  fi
  if [[ -n $meshes ]]; then words+=(--meshes "$meshes"); fi
  if [[ -n $solvers && -z $adds_solvers ]]; then words+=(--solvers "$solvers"); fi
  if [[ -n $peers ]]; then words+=(--peers "$peers"); fi
  if [[ -n $resumed ]]; then words+=(--resume "$resumed"); fi
  if [[ -n $old_run ]]; then words+=(--run "$old_run"); fi
  if [[ -n $only ]]; then words+=(--only "$only"); fi
  "$python" "$root/tools/check_words.py" "${words[@]}"
}

# choose_out: sets `out`, the folder that `run` writes and that check and plot read.
choose_out() {
  [[ -z $out ]] || return 0
  local runs="$root/results/runs" file
  if has_step run; then
    out="$runs/$(date -u +%Y%m%dT%H%M%SZ)-$corpus"
  elif has_step check || has_step plot; then
    for file in "$runs"/*/run.json; do # their names begin with the time, so the last is the newest
      [[ -f $file ]] && out=${file%/*}
    done
    [[ -n $out ]] || die "there is no run in $runs; start one with ./run_all.sh run"
  fi
}

run_steps() {
  local ordered=() step number=0 began
  for step in "${known_steps[@]}"; do
    if has_step "$step"; then ordered+=("$step"); fi
  done
  for step in "${ordered[@]}"; do
    number=$((number + 1))
    say "[$number/${#ordered[@]}] $step"
    current=$step
    began=$SECONDS
    "step_$step"
    say "[$number/${#ordered[@]}] $step: done in $((SECONDS - began)) s"
  done
  current=
}

report_failure() {
  local status=$?
  if [[ $status -ne 0 && -n $current ]]; then
    printf '%s: step %s failed; its output is above and in %s\n' "$program" "$current" "$log" >&2
  fi
}

finish() {
  if has_step plot && [[ -z $only ]]; then
    say "Tables: $out/tables (as .md, .csv and .tex)"
    say "Figures: $out/figures (as .png and .pdf, with captions in .md)"
    say "All on one page: $out/report.html"
  elif has_step run; then
    say "Results: $out/run.json"
  fi
  grep '^NOT MEASURED' "$log" || true
  [[ -z $check_failed ]] || die "check failed: what is wrong is listed above and in $log"
}

given=("$@")
parse_options "$@"
complete_options
bench="$root/build/$preset/geodesic-bench"
choose_out
start_log run_all
trap report_failure EXIT
groups=(python)
if has_step build; then groups+=(build); fi
if has_step peers; then groups+=(peers); fi
find_python || set_up "$install" python
check_words
set_up "$install" "${groups[@]}"
run_steps
finish
