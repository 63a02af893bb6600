"""A Slurm cluster on this machine: a controller and some nodes, with their own folder.

Needs Debian's packages slurmctld, slurmd and munge. Needs root, and the jobs run as root. Other Slurm
daemons of the machine are not changed. All daemons listen on 127.0.0.1 only.
"""

from __future__ import annotations

import os
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from types import TracebackType

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol")
LOW, HIGH = "low", "high"
"""Partitions. Jobs of HIGH preempt jobs of LOW, which are queued again."""
MEMORY = 600
"""Memory of a node, in megabytes."""
SECONDS = 30
"""Time limit for the start of the cluster, in seconds."""

CONFIGURATION = """
ClusterName=geodesic
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket={folder}/munge/socket
SlurmctldPort={port}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
CommunicationParameters=NoAddrCache,NoInAddrAny,NoCtldInAddrAny
MailProg=/bin/true
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SchedulerParameters=sched_interval=1,bf_interval=1,batch_sched_delay=0,sched_min_interval=0
JobAcctGatherType=jobacct_gather/linux
JobAcctGatherFrequency=task=1
JobAcctGatherParams=OverMemoryKill
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
KillWait=2
SlurmdTimeout=4
ReturnToService=2
NodeName=n[1-{nodes}] NodeHostname={host} NodeAddr=127.0.0.1 Port=[{first}-{last}] CPUs=1 RealMemory={memory}
PartitionName={low} Nodes=ALL Default=YES PriorityTier=1 PreemptMode=REQUEUE
PartitionName={high} Nodes=ALL PriorityTier=2 PreemptMode=OFF
"""


def why_not() -> str:
    """Returns the reason why no cluster can run here; empty if one can."""
    missing = [name for name in PROGRAMS if _found(name) is None]
    if missing:
        return (
            f"Slurm is not installed ({', '.join(missing)}): "
            "apt-get install --no-install-recommends slurmctld slurmd munge"
        )
    return "" if os.geteuid() == 0 else "Slurm's daemons need root here"


def _found(name: str) -> str | None:
    return shutil.which(name, path=f"{os.environ.get('PATH', '')}:/usr/sbin:/usr/bin")


class Cluster:
    """A context manager that runs a cluster. Commands of Slurm need its `environment`."""

    def __init__(self, nodes: int = 3) -> None:
        self.nodes = nodes
        self.folder = Path(tempfile.mkdtemp(prefix="slurm-", dir="/tmp"))
        self.folder.chmod(0o755)
        self.ports = _free_ports(nodes + 1)
        self.environment = os.environ | {"SLURM_CONF": str(self.folder / "slurm.conf")}
        self._daemons: dict[str, subprocess.Popen[bytes]] = {}

    def __enter__(self) -> Cluster:
        try:
            self._configure()
            self._start_munge()
            self._start("slurmctld", "-D", "-i")
            for node in range(1, self.nodes + 1):
                self.start_node(node)
            self._wait_for_nodes()
        except BaseException:
            self.__exit__(None, None, None)
            raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if "slurmctld" in self._daemons:
            self.call("scancel", "--full", "--signal=KILL", f"--user={os.getuid()}", check=False)
        for node in range(1, self.nodes + 1):
            self.stop_node(node)
        for name in [name for name in ("slurmctld", "munged") if name in self._daemons]:
            self._stop(name)
        if kind is None:
            shutil.rmtree(self.folder, ignore_errors=True)
        else:
            print(f"the cluster's logs are in {self.folder}", file=sys.stderr)

    def call(self, *words: object, check: bool = True) -> str:
        """Runs a command of Slurm and returns its output."""
        ended = subprocess.run(
            [str(word) for word in words], env=self.environment, capture_output=True, text=True,
            timeout=60,
        )  # fmt: skip
        if check and ended.returncode != 0:
            raise RuntimeError(f"{words[0]}: {ended.stderr.strip()}")
        return ended.stdout

    def start_delayed(self) -> None:
        """Starts the jobs that were queued again. Slurm delays them by two minutes, to put their node in order."""
        for line in self.call("squeue", "-h", "-r", "-t", "PENDING", "-o", "%A|%r").splitlines():
            job, reason = line.split("|")
            if reason == "BeginTime":
                self.call("scontrol", "update", f"JobId={job}", "StartTime=now", check=False)

    def running_on(self, name: str) -> list[str]:
        """Returns the nodes that run jobs whose name contains `-name-`."""
        text = self.call("squeue", "-h", "-r", "-t", "RUNNING,COMPLETING", "-o", "%j|%N")
        jobs = (line.split("|") for line in text.splitlines())
        return [node for job, node in jobs if f"-{name}-" in job]

    def start_node(self, node: int) -> None:
        (self.folder / f"spool-n{node}").mkdir(exist_ok=True)
        self._start(f"slurmd-n{node}", "-D", "-N", f"n{node}")

    def stop_node(self, node: int) -> None:
        """Simulates a power failure: kills the daemon and the jobs of the node at once."""
        self._stop(f"slurmd-n{node}", signal.SIGKILL)
        processes = self._processes_of(node)
        # They are stopped first. Otherwise one could see another one end and record a crash.
        for how in (signal.SIGSTOP, signal.SIGKILL):
            for process in processes:
                try:
                    os.kill(process, how)
                except ProcessLookupError:
                    continue

    def _processes_of(self, node: int) -> list[int]:
        """Returns the process ids of this cluster's jobs on the node, with the processes that started them."""
        wanted = (f"SLURM_CONF={self.folder}/slurm.conf", f"SLURMD_NODENAME=n{node}")
        found = []
        for entry in Path("/proc").iterdir():
            try:
                if not entry.name.isdigit():
                    continue
                variables = (entry / "environ").read_bytes().decode(errors="replace").split("\0")
                words = (entry / "cmdline").read_bytes().decode(errors="replace")
            except OSError:
                continue  # the process has ended
            is_step = words.startswith("slurmstepd") and wanted[0] in variables
            if set(wanted) <= set(variables) or (is_step and f"SLURM_NODE=n{node}" in variables):
                found.append(int(entry.name))
        return found

    def _configure(self) -> None:
        for name in ("munge", "state"):
            (self.folder / name).mkdir(mode=0o755)
        key = self.folder / "munge" / "key"
        key.write_bytes(secrets.token_bytes(1024))
        key.chmod(0o400)
        text = CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], folder=self.folder, nodes=self.nodes,
            port=self.ports[0], first=self.ports[1], last=self.ports[-1], memory=MEMORY, low=LOW,
            high=HIGH,
        )  # fmt: skip
        (self.folder / "slurm.conf").write_text(text)

    def _start_munge(self) -> None:
        here = self.folder / "munge"
        options = {"key-file": "key", "socket": "socket", "pid-file": "pid", "log-file": "log",
                   "seed-file": "seed"}  # fmt: skip
        words = [f"--{option}={here / name}" for option, name in options.items()]
        self._start("munged", "--foreground", "--force", *words)
        self._wait(lambda: (here / "socket").exists(), "munge")

    def _start(self, name: str, *words: str) -> None:
        program = _found(name.split("-")[0])
        assert program is not None
        log = self.folder / f"{name}.out"
        with log.open("ab") as output:
            self._daemons[name] = subprocess.Popen(
                [program, *words], env=self.environment, stdin=subprocess.DEVNULL, stdout=output,
                stderr=output, start_new_session=True,
            )  # fmt: skip

    def _stop(self, name: str, how: signal.Signals = signal.SIGTERM) -> None:
        daemon = self._daemons.pop(name, None)
        if daemon is None:
            return
        daemon.send_signal(how)
        try:
            daemon.wait(10)
        except subprocess.TimeoutExpired:
            daemon.kill()
            daemon.wait()

    def _wait_for_nodes(self) -> None:
        def up() -> bool:
            found = self.call("sinfo", "--noheader", "--Node", "--format=%N %t", check=False)
            return len({line for line in found.splitlines() if line.endswith(" idle")}) == self.nodes

        self._wait(up, "the nodes")

    def _wait(self, done: Callable[[], bool], what: str) -> None:
        deadline = time.monotonic() + SECONDS
        while not done():
            ended = [name for name, daemon in self._daemons.items() if daemon.poll() is not None]
            if ended or time.monotonic() > deadline:
                raise RuntimeError(f"Slurm does not come up: {', '.join(ended) or what}: {self._said()}")
            time.sleep(0.1)

    def _said(self) -> str:
        """The last lines of the logs."""
        lines = []
        for log in sorted(self.folder.glob("*.log")) + sorted(self.folder.glob("*.out")):
            text = log.read_text(errors="replace").strip().splitlines()
            lines += [f"{log.name}: {line}" for line in text[-3:]]
        return "; ".join(lines)


def _free_ports(count: int) -> list[int]:
    """Returns consecutive ports that are not in use."""
    for first in range(21000 + os.getpid() % 1000 * 10, 65000, count):
        try:
            for port in range(first, first + count):
                with socket.socket() as one:
                    one.bind(("127.0.0.1", port))
        except OSError:
            continue
        return list(range(first, first + count))
    raise RuntimeError("no free ports")
