"""Mimic joints: independent with a warning, or slaved and resolved."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from adagen.model import Mimic
from adagen.urdf import Reading
from tests.urdf.texts import Y, joint, link, robot

Read = Callable[..., Reading]


def hand(*mimics: str, kinds: dict[int, str] | None = None, tip: str | None = None) -> str:
    """A chain of as many joints as mimics are given ("" for nothing)."""
    parts = [link("l0")]
    for i, mimic in enumerate(mimics, 1):
        last = tip is not None and i == len(mimics)
        parts.append(link(f"l{i}", tip or "") if last else link(f"l{i}"))
        kind = (kinds or {}).get(i, "revolute")
        parts.append(joint(f"j{i}", f"l{i - 1}", f"l{i}", kind, Y + mimic))
    return robot(*parts)


FOLLOW_1 = '<mimic joint="j1" multiplier="2" offset="0.5"/>'


def test_independent_by_default_with_a_warning(read: Read) -> None:
    reading = read(hand("", FOLLOW_1))
    assert [j.mimic for j in reading.model.joints] == [None, None]
    assert len(reading.warnings) == 1
    assert 'robot.urdf:7: warning: joint "j2" mimics "j1" but is independent' in reading.warnings[0]
    assert "--mimic" in reading.warnings[0]


def test_many_mimics_are_one_warning(read: Read) -> None:
    (warning,) = read(hand("", *[FOLLOW_1] * 9)).warnings
    assert "robot.urdf:7: warning: 9 joints mimic others but are independent here" in warning
    assert '("j2", "j3", "j4" and 6 more): --mimic makes them follow' in warning


def test_slaved(read: Read) -> None:
    reading = read(hand("", FOLLOW_1, '<mimic joint="j1"/>'), mimic=True)
    assert [j.mimic for j in reading.model.joints] == [None, Mimic(0, 2.0, 0.5), Mimic(0, 1.0, 0.0)]
    assert reading.warnings == ()


def test_chains_of_mimics_end_at_an_independent_joint(read: Read) -> None:
    # q2 = 2 q3 + 0.5, q3 = -3 q4 + 0.25: q2 = -6 q4 + 1.0; q4 comes after both
    text = hand(
        "",
        '<mimic joint="j3" multiplier="2" offset="0.5"/>',
        '<mimic joint="j4" multiplier="-3" offset="0.25"/>',
        "",
    )
    joints = read(text, mimic=True).model.joints
    assert joints[1].mimic == Mimic(3, -6.0, 1.0)
    assert joints[2].mimic == Mimic(3, -3.0, 0.25)


@pytest.mark.parametrize("mimic", [False, True])
def test_circles_are_refused(mimic: bool, refusal: Callable[..., str]) -> None:
    text = hand("", '<mimic joint="j3"/>', '<mimic joint="j2"/>')
    assert '"j2", "j3" mimic each other in a circle' in refusal(text, mimic=mimic)


@pytest.mark.parametrize("kinds", [{1: "spherical"}, {2: "planar"}, {1: "fixed"}])
def test_only_joints_of_one_degree_of_freedom(
    kinds: dict[int, str], read: Read, refusal: Callable[..., str]
) -> None:
    text = hand("", FOLLOW_1, "", kinds=kinds)
    assert 'joint "j2" mimics "j1"' in refusal(text, mimic=True)
    assert read(text).model.joints


def test_products_too_large(refusal: Callable[..., str]) -> None:
    big = '<mimic joint="j{}" multiplier="1e30"/>'
    assert "too large" in refusal(hand("", big.format(1), big.format(2)), mimic=True)


def test_a_massless_tip_may_be_driven(read: Read, refusal: Callable[..., str]) -> None:
    text = hand("", FOLLOW_1, tip=" ")
    assert 'joint "j2" moves no mass' in refusal(text)
    assert read(text, mimic=True).model.joints[1].mimic is not None


def test_slaving_does_not_hide_a_massless_joint(refusal: Callable[..., str]) -> None:
    assert 'joint "j3" moves no mass' in refusal(hand("", FOLLOW_1, "", tip=" "), mimic=True)
