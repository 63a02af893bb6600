#!/usr/bin/env bash
# A run of geodesic-bench as an array job of Slurm: a shard of the run for each task. Copy this file, add
# #SBATCH lines as your cluster needs them, and submit it where geodesic-bench is on the PATH:
#
#   sbatch --array=1-32 --mem=16G slurm.sh --out DIR [OPTION of geodesic-bench run]...
#
# DIR and the meshes must be on a file system that the nodes share. Task N writes DIR/shards/N. Slurm starts
# a task again when its node fails or another job takes its place. After any other end (cancelled, out of
# time), submit the same line again: each task then measures only what its shard lacks. At the end:
#
#   geodesic-bench merge DIR/shards --out DIR/whole
#   geodesic-bench report DIR/whole
#
#SBATCH --job-name=geodesic-bench
#SBATCH --ntasks=1
#SBATCH --requeue
#SBATCH --open-mode=append
set -euo pipefail

words=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --out=*) out=${1#*=} ;;
    --out) out=${2:?--out needs a folder}; shift ;;
    *) words+=("$1") ;;
  esac
  shift
done
shard=${out:?the folder is missing: --out DIR}/shards/${SLURM_ARRAY_TASK_ID:?submit this with sbatch --array=1-N}

# Below the limit of the job, so that a solver that needs more is a row of the results and not the end of
# the job. Without --mem it is the default of geodesic-bench run.
if [[ ${SLURM_MEM_PER_NODE:-0} -gt 0 && " ${words[*]}" != *" --memory-limit"* ]]; then
  words+=(--memory-limit "$((SLURM_MEM_PER_NODE * 9 / 10))M")
fi

where=--out
if [[ -f $shard/request.json ]]; then where=--resume; fi  # it refuses other options than before
exec geodesic-bench run "${words[@]}" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" "$where" "$shard"
