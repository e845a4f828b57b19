"""Files of hosts: what mpiexec takes, and what is refused by line."""

from __future__ import annotations

from pathlib import Path

import pytest

from adagen.errors import InputError
from adagen.schedule import Host, read_hosts


def test_open_mpi_and_mpich_files_are_read(tmp_path: Path) -> None:
    file = tmp_path / "hosts"
    file.write_text(
        "# the cluster\n\nnode1 slots=16 max_slots=32\n10.0.0.2\tslots = 8\nnode-3.site:4 # fast\n"
        "node4\nnode1\n"
    )
    assert read_hosts(file) == (
        Host("node1", 17),
        Host("10.0.0.2", 8),
        Host("node-3.site", 4),
        Host("node4", 1),
    )


@pytest.mark.parametrize("line", ["node1 slots=0", "node1:0", "node1 cores=3", "-x", "a b", "a:b"])
def test_a_line_that_is_no_host_is_refused(line: str, tmp_path: Path) -> None:
    file = tmp_path / "hosts"
    file.write_text(f"node0\n{line}\n")
    with pytest.raises(InputError, match="not a host") as found:
        read_hosts(file)
    assert found.value.line == 2


def test_no_hosts_are_refused(tmp_path: Path) -> None:
    file = tmp_path / "hosts"
    file.write_text("# nobody\n")
    with pytest.raises(InputError, match="names no host"):
        read_hosts(file)
    with pytest.raises(InputError, match="cannot read the hosts"):
        read_hosts(tmp_path / "none")
    file.write_bytes(b"\xff")
    with pytest.raises(InputError, match="UTF-8"):
        read_hosts(file)
