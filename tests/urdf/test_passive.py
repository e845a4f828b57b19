"""Damping and friction of <dynamics>, read where they are asked for; rotors that save a robot."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from adagen.errors import InputError
from adagen.model import Model, Passive
from adagen.scene import read_scene
from adagen.urdf import Reading, check_reduced, read_robot
from tests.urdf.texts import BODY, Y, joint, link, robot

DYNAMICS = '<dynamics damping="0.5" friction="0.25"/>'


def read(folder: Path, text: str, **options: object) -> Reading:
    path = folder / "r.urdf"
    path.write_text(text)
    return read_robot(path, **options)  # type: ignore[arg-type]


def one(inside: str, child: str = BODY) -> str:
    return robot(link("a"), link("b", child), joint("j1", "a", "b", inside=Y + inside))


def test_what_is_asked_for_is_modelled_and_the_rest_is_warned_of(tmp_path: Path) -> None:
    text = one(DYNAMICS)
    plain = read(tmp_path, text)
    assert plain.model.joints[0].passive == Passive()
    assert plain.warnings == (
        f'{tmp_path}/r.urdf:5: warning: damping and friction of joint "j1" are not modelled: '
        'a scene with damping = "urdf" and friction = "urdf" models them',
    )
    damped = read(tmp_path, text, effects=["damping"])
    assert damped.model.joints[0].passive == Passive(damping=0.5)
    (line,) = damped.warnings
    assert line.endswith(
        'friction of joint "j1" is not modelled: a scene with friction = "urdf" models it'
    )
    both = read(tmp_path, text, effects=["damping", "friction"])
    assert both.model.joints[0].passive == Passive(damping=0.5, friction=0.25)
    assert both.warnings == plain.ignored == both.ignored == ()


def test_many_joints_take_one_line_for_each_effect(tmp_path: Path) -> None:
    parts = [link("l0"), link("l9"), joint("j9", "l0", "l9", "fixed", Y + DYNAMICS)]
    for k in range(1, 7):
        inside = f'<dynamics damping="{k}" friction="{0.1 * (k > 4)}" K="7" D="x"/>'
        parts += [link(f"l{k}"), joint(f"j{k}", f"l{k - 1}", f"l{k}", inside=Y + inside)]
    warnings = read(tmp_path, robot(*parts)).warnings
    assert [line.partition("warning: ")[2] for line in warnings] == [
        'damping of 6 joints is not modelled ("j1", "j2", "j3" and 3 more): a scene with '
        'damping = "urdf" models it',
        'K and D of 6 joints are not modelled ("j1", "j2", "j3" and 3 more)',
        'friction of 2 joints is not modelled ("j5", "j6"): a scene with friction = "urdf" models '
        "it",
    ]


@pytest.mark.parametrize("kind", ["planar", "floating"])
def test_joints_of_several_freedoms_say_that_nothing_models_it(kind: str, tmp_path: Path) -> None:
    """Whatever a scene asks for: their damping was left out silently."""
    text = robot(link("a"), link("b", BODY), joint("j1", "a", "b", kind, DYNAMICS))
    for effects in ([], ["damping"], ["damping", "friction"]):
        found = read(tmp_path, text, effects=effects, decided=lambda _effect, _joint: True)
        assert found.model.joints[0].passive == Passive()
        (line,) = found.warnings
        assert line.endswith(
            'damping and friction of joint "j1" are not modelled: no single meaning for a joint of '
            "several degrees of freedom"
        )


def test_spherical_joints_are_damped_alike_about_all_axes(tmp_path: Path) -> None:
    text = robot(link("a"), link("b", BODY), joint("j1", "a", "b", "spherical", DYNAMICS))
    found = read(tmp_path, text, effects=["damping", "friction"])
    assert found.model.joints[0].passive == Passive(damping=0.5)
    (line,) = found.warnings
    assert 'friction of joint "j1" is not modelled: no single meaning' in line


@pytest.mark.parametrize(
    ("said", "effects"),
    [
        ("", ["damping", "friction"]),
        ("damping = 0", ["friction"]),
        ('damping = "urdf"\nfriction = 0.1', []),
        ("[joints.j1]\ndamping = 0.2", ["friction"]),
        ("lock_all_but = []", []),
        ("[lock]\nj1 = 0.5", []),
        ('lock_all_but = ["j1"]', ["damping", "friction"]),
    ],
)
def test_what_a_scene_decides_is_not_warned_of(
    said: str, effects: list[str], tmp_path: Path
) -> None:
    (tmp_path / "s.toml").write_text(said)
    scene = read_scene(tmp_path / "s.toml")
    found = read(tmp_path, one(DYNAMICS), effects=scene.from_urdf, decided=scene.decides)
    words = " ".join(found.warnings).partition(" of joint")[0].split()
    assert [word for word in words if word in ("damping", "friction")] == effects


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


def test_what_single_readers_would_model_is_told_once(tmp_path: Path) -> None:
    scaled = '<contact><inertia_scaling value="{}"/></contact>'
    gazebo = '<gazebo reference="b"><turnGravityOff>{}</turnGravityOff></gazebo>\n'
    drake = '<transmission><d:rotor_inertia xmlns:d="http://drake" value="1e-4"/></transmission>\n'
    links = link("a", BODY + scaled.format("3.0")), link("b", BODY + scaled.format("3"))
    text = robot(*links, joint("j1", "a", "b"), gazebo.format("true"), drake)
    said = [line.partition("warning: ")[2] for line in read(tmp_path, text).warnings]
    assert said == [
        "inertia scaling (Bullet's <inertia_scaling>) in 2 places is not modelled",
        "gravity switched off (Gazebo's <turnGravityOff>) in 1 place is not modelled",
        "rotor inertia (Drake's <rotor_inertia>) in 1 place is not modelled",
    ]
    plain = robot(link("a", BODY + scaled.format("1.0")), link("b"), joint("j1", "a", "b"))
    harmless = plain.replace("</robot>", gazebo.format("false") + "</robot>")
    assert read(tmp_path, harmless).warnings == ()
