"""Machines in levels: what messages cost, and files that are refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from adagen.errors import InputError
from adagen.schedule import read_fabric, shipped_fabric
from adagen.schedule.fat_tree import between_hosts, parse_fabric

NODE = '[[level]]\nname = "node"\nsize = 4\n'
SWITCH = '[[level]]\nname = "switch"\nsize = 2\nsend = 0.1\nlatency = 1\nnumber = 0.001\n'


def test_the_lowest_level_that_holds_both_decides() -> None:
    fabric = parse_fabric(f"{NODE}{SWITCH}{SWITCH.replace('latency = 1', 'latency = 3')}", "x")
    assert fabric.processes == 16
    assert fabric.links(0, 3) is None and fabric.links(12, 15) is None
    latencies = [costs.latency for k in (4, 7, 8, 15) if (costs := fabric.links(3, k))]
    assert latencies == [1, 1, 3, 3]
    assert [(host.name, host.slots) for host in fabric.hosts] == [(f"node{k}", 4) for k in range(4)]
    assert fabric.network(0, 1).latency == 1 and fabric.network(1, 2).latency == 3
    with pytest.raises(ValueError, match="no room"):
        fabric.links(0, 16)


def test_hosts_that_are_named_have_one_network() -> None:
    fabric = parse_fabric(NODE + SWITCH, "x")
    links = between_hosts([0, 0, 1], lambda _a, _b: fabric.network(0, 1))
    far = links(1, 2)
    assert links(0, 1) is None and far is not None and far.latency == 1


def test_the_shipped_one_has_1024_processes(tmp_path: Path) -> None:
    fabric = shipped_fabric()
    assert fabric.processes == 1024 and len(fabric.hosts) == 32
    file = tmp_path / "levels.toml"
    file.write_text(NODE + SWITCH)
    assert read_fabric(file).processes == 8


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", r"tables \[\[level\]\]"),
        ("level = 3", r"tables \[\[level\]\]"),
        ("[[level]\n", "not TOML"),
        (f"{NODE}\n[switch]\nsize = 1\n", "unknown key 'switch'"),
        (NODE + "latency = 1\n", "level 1: unknown key 'latency'"),
        (NODE + SWITCH.replace("number = 0.001\n", ""), "level 2: number is missing"),
        (NODE.replace("4", "0"), "level 1: size must be a whole number"),
        (NODE.replace("4", "true"), "level 1: size must be a whole number"),
        (NODE.replace('"node"', '"a node"'), "level 1: name must be a word"),
        (NODE + SWITCH.replace("latency = 1", "latency = -1"), "level 2: latency must be"),
        (NODE + SWITCH.replace("latency = 1", 'latency = "1"'), "level 2: latency must be"),
        (NODE.replace("4", "60000") + SWITCH, "at most 65536"),
    ],
)
def test_what_is_no_fabric_is_refused(text: str, said: str, tmp_path: Path) -> None:
    file = tmp_path / "levels.toml"
    file.write_text(text)
    with pytest.raises(InputError, match=said):
        read_fabric(file)


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot read the levels"):
        read_fabric(tmp_path / "none.toml")
    (tmp_path / "x.toml").write_bytes(b"\xff")
    with pytest.raises(InputError, match="UTF-8"):
        read_fabric(tmp_path / "x.toml")
