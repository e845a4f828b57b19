"""Damping and friction of <dynamics>, read where they are asked for; rotors that save a robot."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from adagen.errors import InputError
from adagen.model import Model, Passive
from adagen.urdf import Reading, check_reduced, read_robot
from tests.urdf.texts import BODY, Y, joint, link, robot

DYNAMICS = '<dynamics damping="0.5" friction="0.25"/>'


def read(folder: Path, text: str, **options: object) -> Reading:
    path = folder / "r.urdf"
    path.write_text(text)
    return read_robot(path, **options)  # type: ignore[arg-type]


def one(inside: str, child: str = BODY) -> str:
    return robot(link("a"), link("b", child), joint("j1", "a", "b", inside=Y + inside))


def test_what_is_asked_for_is_modelled_and_the_rest_is_told(tmp_path: Path) -> None:
    text = one(DYNAMICS)
    plain = read(tmp_path, text)
    assert plain.model.joints[0].passive == Passive()
    assert "joint damping and friction: 1, not modelled" in plain.ignored
    damped = read(tmp_path, text, effects=["damping"])
    assert damped.model.joints[0].passive == Passive(damping=0.5)
    assert "joint friction: 1, not modelled" in damped.ignored
    both = read(tmp_path, text, effects=["damping", "friction"])
    assert both.model.joints[0].passive == Passive(damping=0.5, friction=0.25)
    assert not any("friction" in line for line in both.ignored)


@pytest.mark.parametrize(
    ("inside", "words"),
    [
        ('<dynamics damping="-1"/>', "damping -1.0 is negative"),
        ('<dynamics damping="nan"/>', "damping of <dynamics>"),
        ('<dynamics dampin="1"/>', 'unknown attribute "dampin"'),
    ],
)
def test_bad_values_are_refused_only_where_they_are_asked_for(
    inside: str, words: str, tmp_path: Path
) -> None:
    read(tmp_path, one(inside))
    with pytest.raises(InputError, match=words) as refusal:
        read(tmp_path, one(inside), effects=["damping"])
    assert refusal.value.line is not None


def test_a_joint_that_moves_no_mass_may_move_a_rotor(tmp_path: Path) -> None:
    reading = read(tmp_path, one("", child=""), check=False)
    with pytest.raises(InputError, match="moves no mass"):
        check_reduced(reading, reading.model)

    def changed(**changes: object) -> Model:
        only = replace(reading.model.joints[0], **changes)  # type: ignore[arg-type]
        return replace(reading.model, joints=(only,))

    assert check_reduced(reading, changed(passive=Passive(rotor_inertia=0.1))) == ()
    assert check_reduced(reading, changed(prescribed=True)) == ()
