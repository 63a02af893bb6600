#!/usr/bin/env bash
# Tests runs on a temporary Slurm cluster with faults. See --help.
set -euo pipefail

program=slurm.sh
root=$(unset CDPATH; cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
# shellcheck source=tools/common.sh
source "$root/tools/common.sh"

presets=(ci release)
preset=ci
install=yes

usage() {
  cat <<EOF
Usage: tests/slurm/slurm.sh [OPTION...]

Brings up a Slurm cluster of three nodes on this machine (its own daemons, ports and folder, on
127.0.0.1), measures small runs as array jobs on it, and lets things happen to them: a node goes
down, processes are killed, jobs are cancelled, preempted, and need more memory than they have.
Each merged run must be the run in one piece, apart from times. Takes three minutes, and root;
where Slurm cannot be had, the tests are skipped with the reason.

Options:
  --preset NAME   the build to use: ci (default) or release
  --no-install    never install a package
  --help          this text
EOF
}

take_word() {
  [[ $1 == --preset ]] || unknown_option "$1"
  take_preset "$@"
}

parse_options "$@"
start_log slurm
set_up "$install" python build test
want_optional "$install" optional-slurm
build_preset "$preset" --target geodesic-bench
cd "$root"
GEODESIC_SLURM_TEST=1 GEODESIC_BENCH="$root/build/$preset/geodesic-bench" \
  logged "$python" -m pytest -q -rs tests/slurm
