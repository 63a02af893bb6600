#!/usr/bin/env bash
# Submits examples/slurm.sh in two tasks to a Slurm of one node that lives as long as this script, and queues the
# first one again when it has a cell. Prints the logs of the tasks. Needs root and Debian's packages slurmctld and
# slurmd. The daemons listen on 127.0.0.1 only.
#   tests/reliability/slurm.sh OPTION of examples/slurm.sh...
set -euo pipefail

script=$(unset CDPATH; cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)/examples/slurm.sh
folder=$(mktemp -d)
export SLURM_CONF=$folder/slurm.conf
node=$(hostname -s)
port=$((20000 + $$ % 10000 * 2))
cat >"$SLURM_CONF" <<EOF
ClusterName=geodesic
SlurmctldHost=$node(127.0.0.1)
SlurmUser=root
AuthType=auth/none
CredType=cred/none
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
StateSaveLocation=$folder
SlurmdSpoolDir=$folder
JobRequeue=0
ProctrackType=proctrack/linuxproc
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
NodeName=$node NodeAddr=127.0.0.1 RealMemory=600
PartitionName=all Nodes=ALL Default=YES
EOF

# The jobs end first: slurmd waits for its jobs, and these for slurmctld.
daemons=()
end() {
  scancel --user=root || true
  for _ in {1..50}; do
    [[ -n $(squeue --noheader) ]] || break
    sleep 0.2
  done
  kill -KILL "${daemons[@]}" || true
  rm -r "$folder"
}
trap end EXIT
slurmctld -D -i &>"$folder/slurmctld.log" & daemons+=($!)
slurmd -D &>"$folder/slurmd.log" & daemons+=($!)

# wait_until COMMAND...: repeats the command until it succeeds.
wait_until() {
  until "$@"; do
    [[ $SECONDS -lt 90 ]] || { tail -n 5 "$folder"/*.log; exit 1; }
    sleep 0.2
  done
}

# Slurm would start the task that is queued again after two minutes.
have_ended() {
  scontrol update JobId="${job}_1" StartTime=now &>/dev/null || true
  [[ -z $(squeue --noheader) ]]
}

job=$(sbatch --parsable --array=1-2 --mem=500M --output="$folder/%a.log" "$script" "$@")
wait_until grep -qs '^\[1/' "$folder/1.log"
scontrol requeue "${job}_1"
wait_until have_ended
cat "$folder"/[12].log
