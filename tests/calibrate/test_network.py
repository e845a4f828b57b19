"""``adagen calibrate --hosts``: what messages between hosts take, added to a profile."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from adagen.build import find_toolchain
from adagen.calibrate import profile_text
from adagen.cli import main
from adagen.errors import InputError
from adagen.schedule import load_profile, parse_profile
from adagen.schedule.costs import ChannelCosts
from tests.cost.costs import step_profile
from tests.network import network, why_no_hosts

WHY_NOT = why_no_hosts()


@pytest.mark.slow
@pytest.mark.skipif(bool(WHY_NOT), reason=WHY_NOT)
def test_the_network_is_measured_and_added_to_a_profile(tmp_path: Path) -> None:
    toolchain, delay = find_toolchain(), 100
    hosts, file = tmp_path / "hosts", tmp_path / "profile.toml"
    words = ("calibrate", "--hosts", str(hosts), "--out", str(file), "--json")
    with network(2, toolchain, tmp_path) as net:
        net.delay(delay)
        hosts.write_text("".join(f"{net.address(k)} slots=1\n" for k in (1, 2)))
        done = subprocess.run(
            net.command(sys.executable, "-m", "adagen", *words),
            env={**toolchain.variables(os.environ), **dict(net.environment())},
            capture_output=True,
            text=True,
            timeout=200,
            check=True,
        )
    told = json.loads(done.stdout)
    assert [row["numbers"] for row in told["messages"]] == [1, 12, 42, 120, 480, 1920, 4096]
    assert all(row["way"] > delay for row in told["messages"])
    found, default = load_profile(str(file)).steps, load_profile("default").steps
    assert found is not None and default is not None and found.network is not None
    assert found.network.send + found.network.latency == pytest.approx(
        told["send_us"] + told["latency_us"], abs=1e-6
    )
    assert replace(found, network=None) == default  # nothing else was touched


def test_a_network_in_a_profile_is_written_as_it_is_read() -> None:
    profile = step_profile()
    assert profile.steps is not None and profile.steps.network is None
    far = replace(profile.steps, network=ChannelCosts(1.0, 20.0, 0.01))
    text = profile_text(replace(profile, steps=far), "a remark")
    found = parse_profile(text, "p.toml").steps
    assert found is not None
    assert found.network == far.network
    with pytest.raises(InputError, match="latency must be a number"):
        parse_profile(text.replace("latency = 20.0", "latency = -1"), "p.toml")


def test_one_host_is_no_network(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    hosts = tmp_path / "hosts"
    hosts.write_text("node1 slots=4\n")
    out = str(tmp_path / "x.toml")
    assert main(["calibrate", "--hosts", str(hosts), "--out", out]) == 2
    assert "names one host" in capsys.readouterr().err
    assert main(["calibrate", "--hosts", str(hosts), "--quick", "--out", out]) == 2
    assert "leave out --quick" in capsys.readouterr().err
    hosts.write_text("localhost\n127.0.0.1\n")
    assert main(["calibrate", "--hosts", str(tmp_path / "none"), "--out", out]) == 1
    assert "cannot read the hosts" in capsys.readouterr().err
    assert not Path(out).exists()
