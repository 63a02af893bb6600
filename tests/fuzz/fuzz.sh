#!/usr/bin/env bash
# Fuzzes all readers of a user's files. See --help.
set -euo pipefail

program=fuzz.sh
root=$(unset CDPATH; cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
# shellcheck source=tools/common.sh
source "$root/tools/common.sh"

all_targets=(manifest npy obj off ply points stl suite)
targets=()
seconds=120
jobs=$(processors)
install=yes
work="$root/build/fuzz/runs"

usage() {
  cat <<EOF
Usage: tests/fuzz/fuzz.sh [OPTION...] [TARGET...]

Builds the fuzzers (Clang's libFuzzer with the address and undefined-behaviour sanitizers) and lets
each look for a file that a reader crashes on, takes too long or too much memory for, leaks at, or
refuses with anything but one line. Targets, by default all: ${all_targets[*]}

Options:
  --seconds N     for all targets together, default $seconds
  --jobs N        targets at a time, default the number of processors
  --no-install    never install a package: print the line that would, and stop
  --help          this text

It begins with tests/fuzz/seeds and with what earlier runs found worth keeping in build/fuzz/runs.
A finding is written there, and the exit code is 1. Once repaired it becomes a seed, which the
ordinary tests replay. Log: build/logs/fuzz.log
EOF
}

take_word() {
  case $1 in
    --seconds) take_number "$@"; seconds=$value ;;
    --jobs) take_number "$@"; jobs=$value ;;
    -*) unknown_option "$1" ;;
    *)
      [[ " ${all_targets[*]} " == *" $1 "* ]] ||
        die "unknown target $1; targets are ${all_targets[*]}"
      targets+=("$1")
      ;;
  esac
}

# Prints the seconds of a target: all rounds of `jobs` targets share the time equally.
share() {
  local rounds=$(((${#targets[@]} + jobs - 1) / jobs))
  echo $((seconds > rounds ? seconds / rounds : 1))
}

# start TARGET SECONDS: starts a fuzzer in the background. Its process is $!.
start() {
  local folder="$work/$1"
  rm -rf "$folder/findings"
  mkdir -p "$folder/inputs" "$folder/findings"
  "$root/build/fuzz/fuzz_$1" -max_total_time="$2" -timeout=20 -rss_limit_mb=2048 \
    -malloc_limit_mb=256 -print_final_stats=1 -dict="$root/tests/fuzz/dictionaries/$1.dict" \
    -artifact_prefix="$folder/findings/" "$folder/inputs" "$root/tests/fuzz/seeds/$1" \
    >"$folder/log" 2>&1 &
}

# Fills status[TARGET] with the exit code of every fuzzer.
declare -A status target_of
run_targets() {
  local target ended running=0 each
  each=$(share)
  say "fuzzing ${targets[*]}: $each s each, $jobs at a time"
  trap 'kill "${!target_of[@]}" 2>/dev/null; exit 130' INT TERM
  for target in "${targets[@]}" ""; do
    while [[ $running -eq $jobs || (-z $target && $running -gt 0) ]]; do
      local code=0
      wait -n -p ended || code=$?
      status[${target_of[$ended]}]=$code
      unset "target_of[$ended]"
      running=$((running - 1))
    done
    [[ -n $target ]] || break
    start "$target" "$each"
    target_of[$!]=$target
    running=$((running + 1))
  done
}

# last TARGET PATTERN: prints the number after the last occurrence of the pattern in the log.
last() {
  { grep -aoE "$2 *[0-9]+" "$work/$1/log" || echo "-"; } | tail -n 1 | grep -oE '[0-9]+$|-'
}

report() {
  local target row='%-11s %12s %13s %8s %11s %9s'
  # shellcheck disable=SC2059
  say "$(printf "$row" target executions executions/s edges 'new inputs' findings)"
  for target in "${targets[@]}"; do
    # shellcheck disable=SC2059
    say "$(printf "$row" "$target" "$(last "$target" stat::number_of_executed_units:)" \
      "$(last "$target" stat::average_exec_per_sec:)" "$(last "$target" cov:)" \
      "$(last "$target" stat::new_units_added:)" "$((status[$target] != 0))")"
  done
}

# Prints where each finding is and how to reproduce it. Fails if there is one.
list_findings() {
  local target file found=0
  for target in "${targets[@]}"; do
    [[ ${status[$target]} -ne 0 ]] || continue
    found=1
    say "$target: $(grep -aE -m 1 'what\(\)|runtime error:|ERROR: ' "$work/$target/log" ||
      echo "exit code ${status[$target]}")"
    say "  log: $work/$target/log"
    for file in "$work/$target/findings"/*; do
      [[ -f $file ]] && say "  again: $root/build/fuzz/fuzz_$target $file"
    done
  done
  return $found
}

parse_options "$@"
[[ ${#targets[@]} -gt 0 ]] || targets=("${all_targets[@]}")
start_log fuzz
set_up "$install" build fuzz
build_preset fuzz
run_targets
report
list_findings
