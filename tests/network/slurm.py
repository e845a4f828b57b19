"""Slurm on the hosts of a network: a cluster of its own, with munge, in a temporary folder."""

from __future__ import annotations

import os
import shutil
import subprocess
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.network import Network, why_no_hosts

_TOOLS = ("munged", "slurmctld", "slurmd", "sbatch", "srun", "sinfo")
_START = 60.0  # s until all hosts are idle

# Nothing of the machine's own set-up takes part: no cgroups, no accounts, no pid files of /run.
# Each host says that it has so many cores, whatever it has.
_CONFIGURATION = """\
ClusterName=adagen
SlurmctldHost=node1
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge
CredType=cred/munge
StateSaveLocation={folder}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/%n.pid
SlurmdSpoolDir={folder}/%n
TmpFS={folder}/tmp
SlurmdParameters=config_overrides
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
ReturnToService=2
NodeName=node[1-{hosts}] CPUs={slots} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
"""


def why_no_slurm(*, pmix: bool = False) -> str:
    """Return why Slurm (that starts MPI's processes by PMIx) cannot run here; nothing if it can."""
    missing = [tool for tool in _TOOLS if shutil.which(tool, path=_path()) is None]
    if missing:
        return f"needs {missing[0]} (Debian's packages slurm-wlm and munge have it)"
    if pmix and not any(Path("/usr/lib").glob("*/pmix2/lib/libpmix.so")):
        return "needs libpmix.so, which Slurm loads (Debian's package libpmix-dev has it)"
    return why_no_hosts()


@contextmanager
def slurm(net: Network, slots: int) -> Iterator[tuple[tuple[str, str], ...]]:
    """Run Slurm on all hosts of a network, and end it afterwards.

    Args:
        net: the hosts; the first has the controller, too.
        slots: how many processes each host takes.

    Yields:
        The variables by which Slurm's commands find the cluster, on each host.

    Raises:
        RuntimeError: the hosts are not idle within a minute; with what the daemons said.
    """
    with ExitStack() as stack:
        # Of a short name: the path of a socket has 107 characters at most.
        folder = Path(stack.enter_context(TemporaryDirectory(prefix="adagen-slurm-")))
        configuration = folder / "slurm.conf"
        configuration.write_text(
            _CONFIGURATION.format(folder=folder, hosts=net.hosts, slots=slots), encoding="utf-8"
        )
        # Within a namespace no cgroups are mounted: what looks for their version fails.
        (folder / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\n", encoding="utf-8")
        variables = {**os.environ, "PATH": _path(), "SLURM_CONF": str(configuration)}
        key = folder / "key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        daemons = {
            "munged": (
                *("munged", "--foreground", "--force", f"--socket={folder}/munge"),
                *(f"--key-file={key}", f"--pid-file={folder}/munged.pid"),
                *(f"--log-file={folder}/munged.own", f"--seed-file={folder}/seed"),
            ),
            "slurmctld": net.command("slurmctld", "-D"),
        }
        (folder / "tmp").mkdir()  # of each host its own: PMIx makes a folder of the same name there
        for host in range(1, net.hosts + 1):
            own = f"mkdir {folder}/tmp{host}; mount --bind {folder}/tmp{host} {folder}/tmp"
            daemons[f"slurmd{host}"] = (str(net.agent), f"node{host}", f"{own}; exec slurmd -D")
        for name, words in daemons.items():
            stack.enter_context(_daemon(words, folder / f"{name}.log", variables))
        _await_idle(net, variables, folder)
        yield (("SLURM_CONF", str(configuration)),)


def _path() -> str:
    return f"{os.environ['PATH']}{os.pathsep}/usr/sbin{os.pathsep}/sbin"


@contextmanager
def _daemon(words: tuple[str, ...], log: Path, variables: dict[str, str]) -> Iterator[None]:
    with log.open("w", encoding="utf-8") as out:
        daemon = subprocess.Popen(
            words, stdin=subprocess.DEVNULL, stdout=out, stderr=out, env=variables
        )
    try:
        yield
    finally:
        daemon.terminate()
        try:
            daemon.wait(10)
        except subprocess.TimeoutExpired:
            daemon.kill()
            daemon.wait()


def _await_idle(net: Network, variables: dict[str, str], folder: Path) -> None:
    end = time.monotonic() + _START
    seen = ""
    while time.monotonic() < end:
        asked = subprocess.run(
            net.command("sinfo", "--noheader", "--Node", "--format=%T"),
            capture_output=True,
            text=True,
            env=variables,
        )
        seen = asked.stdout + asked.stderr
        if asked.stdout.split() == ["idle"] * net.hosts:
            return
        time.sleep(0.2)
    logs = "".join(f"{log.name}:\n{log.read_text()}" for log in sorted(folder.glob("*.log")))
    raise RuntimeError(f"Slurm's hosts are not idle: {seen}\n{logs}")
