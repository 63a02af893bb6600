#!/usr/bin/env bash
# The performance gate: a revision against its base. See --help and docs/regression-gate.md.
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

Builds both revisions (the head is the working tree unless named), runs every solver on a
dozen generated meshes, and says whether the head's answers are right and cost no more.
  level 0   distances against the oracles
  level 1   the algorithms' counters against results/baseline/counters.csv
  level 2   instructions inside of solve, counted by callgrind
  level 3   the solvers' peak memory
  level 4   time, both revisions by turns

Options:
  --levels A,B         only these levels, as in 0,1,2,3 (0 is always judged)
  --solvers A,B        only these solvers
  --margin RATIO       what level 4 lets pass (default: 1.10)
  --a-a N              no base: one build against itself, N sessions, for this machine's noise;
                       later margins below it are refused
  --strict             exit with 4 when the machine was too noisy to tell
  --out DIR            for verdict.md, verdict.json, logs and runs (default: build/gate/<time>)
  --update-baseline    rewrite the counters' baseline from the working tree
  --reason TEXT        why, for results/baseline/CHANGES.md
  --no-install         never install a package: print the line that would, and stop
  --help               this text

Exit codes: 0 good, 1 usage or harness error, 2 wrong answer, 3 regression, 4 inconclusive
(only with --strict).
EOF
}

split_options "$@"
set -- "${split[@]}"
while [[ $# -gt 0 ]]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --no-install) install=no; shift ;;
    --levels | --solvers | --margin | --a-a | --out | --reason)
      words+=("$1" "$(value_of "$@")")
      shift 2
      ;;
    --strict | --update-baseline) words+=("$1"); shift ;;
    -*) unknown_option "$1" ;;
    *) words+=("$1"); shift ;;
  esac
done

start_log check_performance
set_up "$install" python build gate
PYTHONPATH="$root" exec "$python" -m gate "${words[@]}"
