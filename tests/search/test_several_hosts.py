"""What pays on several hosts: single evaluations hardly ever, batches where a state is long."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from adagen.calibrate import profile_text
from adagen.cli import main
from adagen.cost import timeline
from adagen.emit import program_of
from adagen.emit.shapes import priced_program
from adagen.plan import make_plan
from adagen.schedule import CostProfile, Host, load_profile
from adagen.schedule.costs import ChannelCosts
from adagen.schedule.fat_tree import between_hosts
from adagen.search import best_schedule
from adagen.search.several_hosts import across_hosts, batch_state_time, network_of, placed
from tests.emitted import plan_of
from tests.golden.make_models import MODELS
from tests.models import serial_chain

LAN = ChannelCosts(1.0, 20.0, 0.008)
NONE = ChannelCosts(0.0, 0.0, 0.0)
FOUR = tuple(Host(f"node{k}", 2) for k in range(4))


def with_network(network: ChannelCosts) -> CostProfile:
    profile = load_profile("default")
    assert profile.steps is not None
    return replace(profile, name="lan", steps=replace(profile.steps, network=network))


def test_processes_fill_hosts_in_equal_parts_up_to_their_slots() -> None:
    assert placed([Host("a", 2), Host("b", 2)], 4) == [0, 0, 1, 1]
    assert placed([Host("a", 1), Host("b", 3)], 4) == [0, 1, 1, 1]
    assert placed([Host("a", 9), Host("b", 9), Host("c", 9)], 4) == [0, 0, 1, 2]


def test_a_message_between_hosts_has_the_network_s_price() -> None:
    plan = plan_of(serial_chain(16), 2)
    profile = with_network(LAN)
    program = priced_program(plan, profile=profile)
    near = timeline(program, profile)
    network = network_of(profile)
    assert timeline(program, profile, between_hosts([0, 0], network)) == near
    assert timeline(program, load_profile("default")) == near
    far = timeline(program, profile, between_hosts([0, 1], network))
    assert far.makespan > near.makespan + 2 * 20  # there and back
    with pytest.raises(ValueError, match="no costs of messages between hosts"):
        network_of(load_profile("default"))


def test_one_evaluation_stays_on_one_host_unless_the_network_is_as_memory() -> None:
    model = serial_chain(60)
    lan = across_hosts(model, FOUR[:2], with_network(LAN))
    assert lan.best_shared is None
    assert [(one.hosts, one.working) for one in lan.shared] == [(2, 1)]
    free = across_hosts(model, [Host("a", 1), Host("b", 1)], with_network(NONE))
    assert free.best_shared is not None
    assert (free.best_shared.hosts, free.best_shared.working) == (2, 2)


def test_batches_pay_where_the_link_is_fast_enough() -> None:
    model = serial_chain(30)
    slow = across_hosts(model, FOUR, with_network(LAN))
    assert [one.hosts for one in slow.batches] == [1, 2, 4]
    assert [one.processes for one in slow.batches] == [2, 4, 8]
    assert slow.best_batches.hosts == 1
    assert slow.batches[-1].handout.limit == "the link of process 0's host"
    fast = across_hosts(model, FOUR, with_network(ChannelCosts(0.2, 2.0, 0.0002)))
    assert fast.best_batches.hosts == 4
    for one in (*slow.batches, *fast.batches):
        assert one.rate <= one.in_place


def test_states_share_the_lanes_of_a_register() -> None:
    model, wide = serial_chain(5), load_profile("xeon")
    assert wide.steps is not None
    table = {**wide.steps.table, "process.register": 32.0}
    narrow = replace(wide, steps=replace(wide.steps, table=table))
    assert batch_state_time(model, narrow) == pytest.approx(2 * batch_state_time(model, wide))


def test_states_of_long_chains_are_priced_one_by_one() -> None:
    """Their batches are solved state by state, in parts: no lane holds another state."""
    model, xeon = serial_chain(520), load_profile("xeon")
    alone = best_schedule(model, 1, xeon, in_parts=True)
    assert alone.parts and not program_of(make_plan(model, alone), batch=True, profile=xeon).batch
    assert batch_state_time(model, xeon) == pytest.approx(alone.makespan)
    assert batch_state_time(serial_chain(500), xeon) < alone.makespan / 2


def test_it_is_said_in_words_and_as_json(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    hosts, profile = tmp_path / "hosts", tmp_path / "lan.toml"
    hosts.write_text("node1 slots=2\nnode2 slots=2\n")
    profile.write_text(profile_text(with_network(LAN), "a LAN"))
    robot = str(MODELS / "chain16.urdf")
    words = ["schedule", robot, "--hosts", str(hosts)]
    assert main([*words, "--profile", str(profile)]) == 0
    said = capsys.readouterr().out
    assert "use one host" in " ".join(said.split())
    assert "distributed" in said and "lan profile" in " ".join(said.split())
    assert main([*words, "--profile", str(profile), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["single"]["hosts"] == 1
    assert [one["hosts"] for one in told["batch"]["several"]] == [1, 2]
    assert main(words) == 2
    assert "adagen calibrate --hosts" in capsys.readouterr().err
    for more in (["--procs", "2"], ["--svg", "x.svg"], ["--form", "ada"], ["--reproducible"]):
        assert main([*words, *more]) == 2
        assert f"leave out {more[0]}" in capsys.readouterr().err


def test_levels_of_a_cluster_stand_for_hosts(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Nothing is measured for them: the shipped profile does."""
    levels = tmp_path / "cluster.toml"
    levels.write_text(
        '[[level]]\nname = "node"\nsize = 2\n'
        '[[level]]\nname = "switch"\nsize = 4\nsend = 0.1\nlatency = 1.3\nnumber = 0.001\n'
    )
    robot = str(MODELS / "arm7.urdf")
    assert main(["schedule", robot, "--hosts", str(levels), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert [one["processes"] for one in told["batch"]["several"]] == [2, 4, 8]
    assert told["single"]["hosts"] == 1 and told["profile"] == "default"
