"""Hosts on this machine: network namespaces, and a switch between them with delay, loss and cuts.

Nothing outside takes part: the namespaces see each other and nothing else.
"""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from itertools import count
from pathlib import Path

from adagen.build import Toolchain, build_executable

SOURCE = Path(__file__).with_name("switch.cpp")

_AGENT = """\
#!/bin/sh
# Stands in for ssh: agent HOST COMMAND... runs a command on a host. Its name ends in its number.
host=${{1##*[!0-9]}}
shift
exec ip netns exec {prefix}$host taskset -c $(((host - 1) % {cores})) unshare --uts --mount sh -c \\
  'mount --bind {names} /etc/hosts; hostname node'$host'; exec sh -c "$*"' sh "$@"
"""
_TOOLS = ("ip", "unshare", "taskset")
_ON_FIRST = 'mount --bind "$0" /etc/hosts; hostname node1; exec "$@"'
_NUMBERS = count(1)  # of the networks of this process


def why_no_hosts() -> str:
    """Return why there can be no hosts here; nothing if there can."""
    missing = [tool for tool in _TOOLS if shutil.which(tool) is None]
    if missing:
        return f"needs {missing[0]} (iproute2 and util-linux have it)"
    if os.geteuid() != 0:
        return "needs root, to make network namespaces"
    if not Path("/dev/net/tun").exists():
        return "needs /dev/net/tun, for the cables between hosts"
    name = f"adagen{os.getpid()}-try"
    made = subprocess.run(["ip", "netns", "add", name], capture_output=True, text=True)
    if made.returncode != 0:
        return f"no network namespaces here: {made.stderr.strip()}"
    _ip("netns", "del", name)
    return ""


@dataclass(frozen=True)
class Network:
    """Hosts of one network, 1 to ``hosts``; each has a core, as far as there are some.

    Attributes:
        hosts: how many.
        prefix: of the namespaces' names; their numbers follow.
        agent: a program that starts a command on a host, as ssh does.
        names: the hosts' names, node1, node2, ..., as in /etc/hosts.
        switch: the process between them.
    """

    hosts: int
    prefix: str
    agent: Path
    names: Path
    switch: subprocess.Popen[str]

    def address(self, host: int) -> str:
        """Return the address of a host, by which MPI knows it."""
        return f"10.77.0.{host}"

    def toolchain(self, toolchain: Toolchain, slots: int = 1) -> Toolchain:
        """Return the toolchain that runs programs on all hosts, so many processes on each."""
        hosts = ",".join(f"{self.address(k)}:{slots}" for k in range(1, self.hosts + 1))
        return replace(
            toolchain,
            mpiexec=(*self.command(*toolchain.mpiexec), "--host", hosts),
            environment=(*toolchain.environment, *self.environment()),
        )

    def command(self, *words: str) -> tuple[str, ...]:
        """Return what runs a command on the first host."""
        first = ("ip", "netns", "exec", f"{self.prefix}1", "taskset", "-c", "0")
        own = ("unshare", "--uts", "--mount", "sh", "-c", _ON_FIRST, str(self.names))
        return (*first, *own, *words)

    def environment(self) -> tuple[tuple[str, str], ...]:
        """Return the variables by which mpiexec reaches the hosts."""
        return (("PRTE_MCA_plm_ssh_agent", str(self.agent)),)

    def delay(self, microseconds: float) -> None:
        """Let packets be under way for so long."""
        self._tell(f"delay {microseconds}")

    def loss(self, share: float) -> None:
        """Lose a share of all packets, 0 to 1."""
        self._tell(f"loss {share}")

    def cut(self, host: int) -> None:
        """Pull a host's cable: nothing gets there or comes from there, and nobody is told."""
        self._tell(f"cut {host}")

    def mend(self, host: int) -> None:
        """Plug it in again."""
        self._tell(f"mend {host}")

    def processes(self, host: int) -> list[int]:
        """Return the processes that run on a host."""
        return [int(word) for word in _ip("netns", "pids", f"{self.prefix}{host}").split()]

    def signal(self, host: int, number: signal.Signals) -> None:
        """Send a signal to all processes of a host."""
        for pid in self.processes(host):
            with suppress(ProcessLookupError):
                os.kill(pid, number)

    def _tell(self, command: str) -> None:
        assert self.switch.stdin is not None and self.switch.stdout is not None
        print(command, file=self.switch.stdin, flush=True)
        assert self.switch.stdout.readline() == "done\n"


@contextmanager
def network(hosts: int, toolchain: Toolchain, folder: Path) -> Iterator[Network]:
    """Make so many hosts, and remove them and what runs on them at the end.

    Args:
        hosts: how many.
        toolchain: whose compiler builds the switch.
        folder: for the agent.
    """
    _clear_away()
    program = build_executable(SOURCE.read_text(), "switch", toolchain)
    prefix = f"adagen{os.getpid()}-{next(_NUMBERS)}-"
    names = [f"{prefix}{k}" for k in range(hosts + 1)]  # 0 is the switch
    agent = folder / "agent"
    known = folder / "names-of-hosts"
    agent.write_text(_AGENT.format(prefix=prefix, cores=os.cpu_count(), names=known))
    agent.chmod(0o755)
    switch = None
    try:
        for name in names:
            _ip("netns", "add", name)
        switch = subprocess.Popen(
            ["ip", "netns", "exec", names[0], str(program), str(hosts)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        assert switch.stdout is not None
        assert switch.stdout.readline() == "ready\n"
        made = Network(hosts, prefix, agent, known, switch)
        lines = [f"{made.address(host)} node{host}\n" for host in range(1, hosts + 1)]
        known.write_text("127.0.0.1 localhost\n" + "".join(lines))
        for host in range(1, hosts + 1):
            _plug_in(made, host)
        yield made
    finally:
        if switch is not None:
            switch.kill()
            switch.communicate()
        for name in names:
            _remove(name)


def _plug_in(made: Network, host: int) -> None:
    name, device = f"{made.prefix}{host}", f"host{host}"
    _ip("-n", f"{made.prefix}0", "link", "set", device, "netns", name)
    _ip("-n", name, "address", "add", f"{made.address(host)}/24", "dev", device)
    for each in ("lo", device):
        _ip("-n", name, "link", "set", each, "up")


def _clear_away() -> None:
    """Remove what is left of tests that were ended by force."""
    for path in Path("/run/netns").glob("adagen*-*"):
        maker = path.name.removeprefix("adagen").partition("-")[0]
        if maker.isdigit() and not Path("/proc", maker).exists():
            _remove(path.name)


def _remove(name: str) -> None:
    """Remove a namespace, and end what still runs in it. Another run may do so at the same time."""
    try:
        for word in _ip("netns", "pids", name).split():
            with suppress(ProcessLookupError):
                os.kill(int(word), signal.SIGKILL)
        _ip("netns", "del", name)
    except RuntimeError:
        if Path("/run/netns", name).exists():
            raise


def _ip(*words: str) -> str:
    done = subprocess.run(["ip", *words], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"ip {' '.join(words)}: {done.stderr.strip()}")
    return done.stdout
