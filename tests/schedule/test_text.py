"""Schedules as text: JSON there and back, the tree, the line, the drawing; wrong ones refused."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from typing import Any
from xml.etree import ElementTree

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.drawing.tree import played_tree, schedule_svg
from adagen.errors import InputError
from adagen.schedule import (
    InvalidSchedule,
    Node,
    Topology,
    deepjson,
    load_profile,
    schedule_line,
    schedule_to_json,
    schedule_tree,
    validate,
)
from adagen.search import find_schedule, schedule_from_json

PAPER = load_profile("paper")
HOSTILE = ('a */ "b"', "<joint>&amp;", "tail\\", "new\nline", "\u202ertl\0", "漢字", "x" * 300)


def hostile() -> Topology:
    return replace(Topology.serial(len(HOSTILE)), names=HOSTILE)


@pytest.mark.parametrize("p", [1, 2, 3, 4, 5])
def test_json_there_and_back(p: int) -> None:
    for topology in (hostile(), Topology.bare((0, 1, 2, 1, 2, 4, 3, 5, 5, 7, 7))):
        schedule = find_schedule(topology, p, profile=PAPER)
        text = schedule_to_json(schedule, topology)
        data = json.loads(text)
        assert data["root"]["joint"] == topology.names[schedule.root.joint]
        assert data["root"]["processes"] == [0, p]
        again = schedule_from_json(text, topology, PAPER)
        validate(again, topology)
        assert (again.makespan, again.loads) == (schedule.makespan, schedule.loads)
        assert again.lower_bound <= schedule.makespan
        assert json.loads(schedule_to_json(again, topology))["root"] == data["root"]


def test_a_very_deep_tree_as_text() -> None:
    topology = Topology.serial(5000)
    schedule = find_schedule(topology, 1, profile=PAPER)
    text = schedule_to_json(schedule, topology)
    again = schedule_from_json(text, topology, PAPER)
    assert again.makespan == schedule.makespan
    assert schedule_tree(schedule, topology).count("\n") == 5000
    assert schedule_line(schedule, topology).startswith("j0@0(|j1(|")


def test_joints_below_one_another_share_a_line_where_the_tree_has_no_costs() -> None:
    topology = Topology.serial(12)
    schedule = find_schedule(topology, 2, profile=PAPER)
    text = schedule_tree(schedule, topology, costs=False)
    assert " us" not in text and "..." not in text
    shown = 0
    for line in text.splitlines():
        several = re.search(r"(j\d+) \.\. (j\d+)  \[.*\]  k=\d  (\d+) joints$", line)
        assert several or re.search(r"j\d+  \[[-0-9]+\]  k=\d$", line), line
        shown += int(several[3]) if several else 1
    assert shown == 12
    assert any(" .. " in line for line in text.splitlines())


def _edit(change: Callable[[dict[str, Any]], Any]) -> str:
    topology = Topology.serial(5)
    data = json.loads(schedule_to_json(find_schedule(topology, 2, profile=PAPER), topology))
    change(data["root"])
    return json.dumps(data)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "not JSON"),
        ("[" * 100_000, "not JSON"),
        ("[1]", "not a schedule"),
        ('{"root": 3}', "not a schedule"),
        ('{"root": {"joint": "j0", "joint": "j1"}}', "given twice"),
        (_edit(lambda root: root.pop("joint")), "without"),
        (_edit(lambda root: root.update(joint="nope")), "has no joint 'nope'"),
        (_edit(lambda root: root.update(index=4)), "has the index 2"),
        (_edit(lambda root: root.update(processes=[0, 0])), "processes"),
        (_edit(lambda root: root.update(processes=[0, "2"])), "processes"),
        (_edit(lambda root: root.update(processes=[1, 2])), "root must have"),
        (_edit(lambda root: root.update(children=3)), "no list"),
        (_edit(lambda root: root["children"].pop()), "is missing"),
        (_edit(lambda root: root["children"][0].update(side="end")), "on the root side"),
        (_edit(lambda root: root["children"].append(root["children"][0])), "more than once"),
        (_edit(lambda root: root["children"][0].update(processes=[0, 2])), "neither share"),
        (_edit(lambda root: root["children"][0].update(processes=[0, 3])), "has not"),
        (_edit(lambda root: root["children"][0].update(joint="j4", index=4)), "j4"),
    ],
)
def test_wrong_schedules_are_refused(text: str, message: str) -> None:
    with pytest.raises(InputError, match=re.escape(message)) as caught:
        schedule_from_json(text, Topology.serial(5), PAPER, "s.json")
    assert str(caught.value).startswith("s.json:") and "\n" not in str(caught.value)


def test_validate_finds_wrong_trees() -> None:
    topology = Topology.serial(4)
    good = find_schedule(topology, 2, profile=PAPER)
    validate(good, topology)
    root = good.root

    def node(n: Node, **change: Any) -> Node:
        keys = ("joint", "processes", "root_side", "end_side", "cost", "boundary")
        return Node(**{**{key: getattr(n, key) for key in keys}, **change})

    swapped = node(root, root_side=root.end_side, end_side=root.root_side)
    for wrong in (
        swapped,
        node(root, root_side=None),
        node(root, boundary=1),
        node(root, joint=9),
        node(root, processes=(0, 3)),
        node(root, cost=1.0),
    ):
        with pytest.raises(InvalidSchedule):
            validate(replace(good, root=wrong), topology)
    with pytest.raises(InvalidSchedule):
        validate(good, Topology.serial(5))


@settings(max_examples=200)
@given(
    st.recursive(
        st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
        lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    ).filter(lambda value: "Infinity" not in json.dumps(value)),
    st.sampled_from([None, 1]),
)
def test_json_without_recursion_is_json(value: Any, indent: int | None) -> None:
    assert json.loads(deepjson.dumps(value)) == value
    assert deepjson.loads(json.dumps(value, indent=indent)) == value


@settings(max_examples=200)
@given(st.text(alphabet='{}[],:"a1 ', max_size=10))
def test_what_is_not_json_is_not_accepted(text: str) -> None:
    try:
        expected = json.loads(text)
    except ValueError:
        with pytest.raises(json.JSONDecodeError):
            deepjson.loads(text)
        return
    if len(re.findall(r'"[^"]*"\s*:', text)) < 2:  # a repeated key is refused here only
        assert deepjson.loads(text) == expected


def test_line_is_safe_in_a_comment() -> None:
    line = schedule_line(find_schedule(hostile(), 2, profile=PAPER), hostile())
    assert re.fullmatch(r"[A-Za-z0-9_.:+@()| -]+", line)
    topology = Topology.serial(3)
    assert schedule_line(find_schedule(topology, 2, profile=PAPER), topology) == (
        "j1@0-1(j0@0 | j2@1)"
    )


@pytest.mark.parametrize("p", [1, 3, 4, 16])
def test_timeline_is_a_schedule(p: int) -> None:
    topology = Topology.bare((0, 1, 2, 1, 2, 4, 3, 5, 5, 7, 7))
    schedule = find_schedule(topology, p, profile=PAPER)
    line = played_tree(schedule)
    assert line.makespan == schedule.makespan
    assert sum(i.what != "wait" for i in line.intervals) == 2 * len(topology)
    for process in range(p):
        own = sorted((i.start, i.end) for i in line.intervals if i.process == process)
        assert all(a[1] == b[0] for a, b in pairwise(own)) and not (own and own[0][0])
    assert all(e.sent <= e.used and e.sender != e.receiver for e in line.exchanges)


def test_drawing_is_well_formed_repeatable_and_complete() -> None:
    for topology, p in ((hostile(), 3), (Topology.serial(200), 8), (Topology.serial(1), 1)):
        schedule = find_schedule(topology, p, profile=PAPER, expansions=200)
        picture = schedule_svg(schedule, topology, "<robot> & \x07")
        assert picture == schedule_svg(schedule, topology, "<robot> & \x07")
        root = ElementTree.fromstring(picture)
        texts = ["".join(e.itertext()) for e in root.iter("{http://www.w3.org/2000/svg}text")]
        if topology.names[0] == "j0":
            for name in topology.names:
                assert texts.count(name) >= 2
        assert "nan" not in picture and "inf" not in picture and "http" not in picture[40:]
        width, height = float(root.attrib["width"]), float(root.attrib["height"])
        for element in root.iter("{http://www.w3.org/2000/svg}text"):
            assert 0 <= float(element.attrib["x"]) <= width
            assert 0 <= float(element.attrib["y"]) <= height
