#!/usr/bin/env bash
# The performance gate: compares a revision with its base. See --help and docs/regression-gate.md.
set -euo pipefail

program=check_performance.sh
root=$(unset CDPATH; cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
# shellcheck source=tools/common.sh
source "$root/tools/common.sh"

install=yes
words=()

usage() {
  cat <<EOF
Usage: ./check_performance.sh BASE_REVISION [HEAD_REVISION] [OPTION...]
       ./check_performance.sh --a-a N [REVISION] [OPTION...]
       ./check_performance.sh --update-baseline --reason "why it may be accepted"

Builds both revisions (the head is the working tree by default), runs every solver on a
dozen generated meshes, and judges whether the head's answers are right and cost no more.
  level 0   distances against the oracles
  level 1   the algorithms' counters against results/baseline/counters.csv
  level 2   instructions inside solve, counted by callgrind
  level 3   the solvers' peak memory
  level 4   time, both revisions in pairs

Options:
  --levels A,B         only these levels, as in 0,1,2,3 (0 is always judged)
  --solvers A,B        only these solvers
  --margin RATIO       the ratio of times that level 4 accepts (default: 1.10)
  --budget SECONDS     of level 4 for rows that the first pairs do not decide (default: 300)
  --a-a N              no base: one build against itself, N sessions, for this machine's noise;
                       later margins below it are refused
  --all                measure on when a failure makes the verdict certain, and time solvers too
                       whose code, counters and instructions are those of the base
  --strict             exit with 4 when a row is not resolved
  --out DIR            for verdict.md, verdict.json, logs and runs (default: build/gate/<time>)
  --update-baseline    rewrite the counters' baseline from the working tree
  --reason TEXT        why, for results/baseline/CHANGES.md
  --no-install         install nothing: print the line that installs what is missing, and stop
  --help               this text

Exit codes: 0 no failure, 1 usage or harness error, 2 wrong answer, 3 regression, 4 not
resolved (only with --strict).
EOF
}

take_word() {
  case $1 in
    --levels | --solvers | --margin | --budget | --a-a | --out | --reason)
      take_value "$@"
      words+=("$1" "$value")
      ;;
    --all | --strict | --update-baseline) words+=("$1") ;;
    -*) unknown_option "$1" ;;
    *) words+=("$1") ;;
  esac
}

parse_options "$@"

start_log check_performance
set_up "$install" python build gate
PYTHONPATH="$root" exec "$python" -m gate "${words[@]}"
