"""What a good file becomes: kinds, axes, order, lumped bodies."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.errors import InputError, UsageError
from adagen.exact import rotation_from_rpy, rounded
from adagen.model import FLOATING, KINDS, Model
from adagen.urdf import Reading, yourdfpy_check
from adagen.urdf.bodies import build, gather
from adagen.urdf.description import describe
from adagen.urdf.document import parse
from adagen.urdf.notes import Notes
from adagen.urdf.tree import make_tree
from tests.urdf.texts import BODY, INERTIA, MASS, Y, joint, link, pair, robot

Read = Callable[..., Reading]


def model_of(text: str, floating: bool = False) -> Model:
    """The model of a text, without yourdfpy and without the checks of the whole."""
    notes = Notes("text")
    description = describe(parse(text, notes), "text", notes)
    return build(
        description.name, gather(description, make_tree(description, notes), floating), {}, floating
    )


@pytest.mark.parametrize(
    ("kind", "name"),
    [
        ("revolute", "revolute"), ("continuous", "revolute"), ("prismatic", "prismatic"),
        ("planar", "planar"), ("spherical", "spherical"), ("ball", "spherical"),
        ("floating", "floating"),
    ],
)  # fmt: skip
def test_kinds(kind: str, name: str, read: Read) -> None:
    (only,) = read(pair(kind=kind)).model.joints
    assert only.kind is KINDS[name]
    assert only.axis.tolist() == ([0, 1, 0] if only.kind.has_axis else [0, 0, 1])


def test_default_axis(read: Read) -> None:
    assert read(pair(j="")).model.joints[0].axis.tolist() == [1.0, 0.0, 0.0]


def test_axes_are_normalised(read: Read) -> None:
    assert read(pair(j='<axis xyz="0 -1e-30 0"/>')).model.joints[0].axis.tolist() == [0, -1, 0]
    axis = read(pair(j='<axis xyz="3e20 0 4e20"/>')).model.joints[0].axis
    assert axis.tolist() == [0.6, 0.0, 0.8]


def test_a_joint_without_axis_may_have_a_zero_one(read: Read) -> None:
    assert read(pair(j='<axis xyz="0 0 0"/>', kind="floating")).model.nv == 6


def test_missing_inertial_has_no_mass(read: Read) -> None:
    text = robot(link("a", ""), link("b"), joint("j", "a", "b"))
    assert read(text).model.links[0].inertia.mass == 0.0


def test_depth_first_by_name_through_fixed_joints(read: Read) -> None:
    text = robot(
        *(link(x) for x in "abcdefg"),
        joint("z", "a", "b"), joint("m", "a", "c", "fixed"), joint("c1", "c", "d"),
        joint("b1", "c", "e"), joint("k", "a", "f"), joint("a1", "b", "g"),
    )  # fmt: skip
    model = read(text).model
    assert [j.name for j in model.joints] == ["k", "b1", "c1", "z", "a1"]
    assert [link_.name for link_ in model.links] == ["a", "f", "e", "d", "b", "g"]
    assert model.links[0].merged == ("c",)
    assert [j.parent for j in model.joints] == [0, 0, 0, 0, 4]


def test_floating_base(read: Read) -> None:
    model = read(pair(), floating=True).model
    assert model.floating
    assert [j.name for j in model.joints] == ["__base__", "j1"]
    assert model.joints[0].kind is FLOATING
    assert model.links[1].inertia.mass == 1.0
    assert (model.nq, model.nv) == (8, 7)


def test_the_name_of_the_base_is_taken(read: Read, refusal: Callable[..., str]) -> None:
    text = pair().replace('"j1"', '"__base__"')
    assert read(text).model.joints[0].name == "__base__"
    assert 'joint "__base__" has the name' in refusal(text, floating=True)


def test_gravity(read: Read) -> None:
    assert read(pair()).model.gravity.tolist() == [0, 0, -9.81]
    assert read(pair(), gravity=(1, 2, 3)).model.gravity.tolist() == [1, 2, 3]
    for bad in [(1, 2), (0, 0, float("nan"))]:
        with pytest.raises(UsageError):
            read(pair(), gravity=bad)


def test_what_is_ignored_is_told(read: Read) -> None:
    odd = '<visual><geometry><teapot/></geometry></visual><collision/><inertia_hint x="nan"/>'
    extra = Y + '<limit lower="nan" upper="1"/><dynamics damping="0.1"/>'
    text = pair(BODY + odd, extra).replace("</robot>", "<gazebo><link/></gazebo></robot>")
    reading = read(text)
    assert reading.ignored == (
        "<gazebo> elements: 1, not modelled",
        "<inertia_hint> elements of a link: 1, not modelled",
        "collisions: 1, not modelled",
        "joint limits (position, velocity, effort): 1, not modelled",
        "visuals: 1, not modelled",
    )
    assert len(reading.warnings) == 2
    assert 'joint "j1": <limit> "nan" is not finite' in reading.warnings[0]
    assert 'robot.urdf:5: warning: damping of joint "j1" is not modelled' in reading.warnings[1]


def test_limits_that_cannot_be_meant_are_one_warning(read: Read) -> None:
    reversed_limit = Y + '<limit lower="1" upper="-1"/>'
    links = "".join(link(f"l{k}") for k in range(4))
    joints = [joint(f"j{k}", f"l{k}", f"l{k + 1}", inside=reversed_limit) for k in range(3)]
    (warning,) = read(robot(links, *joints)).warnings
    assert "lower limit 1 is above the upper one -1 (not used)" in warning
    assert warning.endswith('; 2 more joints have such limits: "j1", "j2"')


def test_a_thousand_unknown_names_take_few_lines(read: Read) -> None:
    odd = "".join(f"<t{i}/>" for i in range(1000))
    ignored = read(pair().replace("</robot>", odd + "</robot>")).ignored
    assert len(ignored) == 21
    assert ignored[-1] == "elements with 980 other names: 980, not modelled"


def test_warnings(read: Read) -> None:
    thin = '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.05"/>'
    turned = '<origin rpy="90 0 0"/>'
    (triangle, degrees) = sorted(
        read(pair(f"<inertial>{turned}{MASS}{thin}</inertial>")).warnings, key=len, reverse=True
    )
    assert "robot.urdf:4: warning: " in triangle
    assert "triangle inequality" in triangle
    assert "radians" in degrees


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_encodings(encoding: str, read: Read) -> None:
    text = pair().replace("j1", "j\u00e9")
    declared = {"utf-8-sig": "utf-8"}.get(encoding, encoding)
    declared = {"latin-1": "iso-8859-1"}.get(declared, declared)
    text = text.replace('version="1.0"', f'version="1.0" encoding="{declared}"')
    assert read(text.encode(encoding)).model.joints[0].name == "j\u00e9"


def test_a_prefix_that_nobody_uses_is_no_namespace(read: Read) -> None:
    text = pair().replace("<robot", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"')
    assert read(text).model.nv == 1


def test_inertia_of_one_link_keeps_its_digits(read: Read) -> None:
    inertia = '<inertia ixx="0.3" ixy="0.01" ixz="0.02" iyy="0.7" iyz="-0.03" izz="0.9"/>'
    text = pair(f'<inertial><origin xyz="0.1 0.2 0.3"/><mass value="0.7"/>{inertia}</inertial>')
    body = read(text).model.links[1].inertia
    assert (body.mass, body.com.tolist()) == (0.7, [0.1, 0.2, 0.3])
    assert body.tensor.tolist() == [[0.3, 0.01, 0.02], [0.01, 0.7, -0.03], [0.02, -0.03, 0.9]]


def test_yourdfpy_must_agree(monkeypatch: pytest.MonkeyPatch, refusal: Callable[..., str]) -> None:
    honest = yourdfpy_check._load

    def spoilt(change: Callable[[Any], object]) -> str:
        def load(document: bytes, notes: Notes) -> Any:
            loaded = honest(document, notes)
            change(loaded)
            return loaded

        monkeypatch.setattr(yourdfpy_check, "_load", load)
        return refusal(pair())

    changes: list[Callable[[Any], object]] = [
        lambda r: r.links.pop(),
        lambda r: r.joints.pop(),
        lambda r: setattr(r.links[1].inertial, "mass", 1.0000000000000002),
        lambda r: setattr(r.links[1], "inertial", None),
        lambda r: r.links[1].inertial.inertia.__setitem__((0, 0), 1.0),
        lambda r: r.links[1].inertial.inertia.__setitem__((0, 1), 1.0),
        lambda r: setattr(r.links[1], "name", "c"),
        lambda r: setattr(r.joints[0], "type", "continuous"),
        lambda r: setattr(r.joints[0], "parent", "b"),
        lambda r: r.joints[0].axis.__setitem__(0, 1e-9),
        lambda r: r.joints[0].origin.__setitem__((0, 3), 1e-9),
        lambda r: r.joints[0].origin.__setitem__((0, 1), 1e-9),
    ]
    for change in changes:
        assert "yourdfpy" in spoilt(change)


def test_yourdfpy_gets_no_visuals(monkeypatch: pytest.MonkeyPatch, read: Read) -> None:
    seen: list[bytes] = []
    honest = yourdfpy_check._load

    def load(document: bytes, notes: Notes) -> Any:
        seen.append(document)
        return honest(document, notes)

    monkeypatch.setattr(yourdfpy_check, "_load", load)
    mesh = '<visual><geometry><mesh filename="x.stl"/></geometry></visual>'
    read(pair(BODY + mesh, Y + '<limit lower="x"/>'))
    assert b"mesh" not in seen[0]
    assert b"limit" not in seen[0]


number = st.floats(-2, 2)
triple = st.tuples(number, number, number)


def spelt(values: tuple[float, ...]) -> str:
    return " ".join(map(repr, values))


def spatial(inertia: Any) -> Any:
    """The 6x6 inertia [angular; linear] about the origin, in double."""
    x, y, z = inertia.com
    c = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    m = inertia.mass
    return np.block([[inertia.tensor - m * c @ c, m * c], [-m * c, m * np.eye(3)]])


@settings(max_examples=40)
@given(triple, triple, triple, triple, st.booleans())
def test_a_fixed_child_adds_its_inertia(
    xyz: tuple[float, ...], rpy: tuple[float, ...], com: tuple[float, ...],
    turn: tuple[float, ...], massive: bool,
) -> None:  # fmt: skip
    """Mass, first and second moment of the lumped body are the sums, for any pose and inertial."""
    tensor = '<inertia ixx="0.3" ixy="0.01" ixz="0.02" iyy="0.4" iyz="-0.03" izz="0.5"/>'
    inertial = f'<origin xyz="{spelt(com)}" rpy="{spelt(turn)}"/><mass value="0.7"/>{tensor}'
    child = f"<inertial>{inertial}</inertial>"
    text = robot(
        link("a"), link("b", BODY if massive else ""), link("c", child), joint("j", "a", "b"),
        joint("f", "b", "c", "fixed", "", f'<origin xyz="{spelt(xyz)}" rpy="{spelt(rpy)}"/>'),
    )  # fmt: skip
    model = model_of(text)
    assert model.links[1].merged == ("c",)
    r, inner = rounded(rotation_from_rpy(rpy)), rounded(rotation_from_rpy(turn))
    ic = inner @ np.array([[0.3, 0.01, 0.02], [0.01, 0.4, -0.03], [0.02, -0.03, 0.5]]) @ inner.T
    at_c = model.links[1].inertia.__class__(0.7, np.array(com), ic)
    x, y, z = xyz
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    motion = np.block([[r.T, np.zeros((3, 3))], [-r.T @ cross, r.T]])
    total = motion.T @ spatial(at_c) @ motion
    if massive:
        total = total + spatial(model_of(pair()).links[1].inertia)
    assert spatial(model.links[1].inertia) == pytest.approx(total, rel=1e-12, abs=1e-12)


def test_a_long_run_of_fixed_joints_keeps_its_digits() -> None:
    """One turn in 1000 steps, and 1000 back: the end is where the start was."""
    parts, n = [link("a"), link("l0"), joint("j", "a", "l0")], 1000
    for i in range(1, n + 1):
        origin = f'<origin xyz="0.1 0 0" rpy="0 0 {2 * np.pi / n!r}"/>'
        parts.append(link(f"l{i}", BODY if i == n else ""))
        parts.append(joint(f"f{i}", f"l{i - 1}", f"l{i}", "fixed", "", origin))
    body = model_of(robot(*parts)).links[1].inertia
    assert body.mass == 2.0
    assert body.com == pytest.approx([0, 0, 0.1], abs=1e-13)


@settings(max_examples=40)
@given(st.lists(st.integers(0, 10**6), min_size=1, max_size=12), st.randoms())
def test_random_trees(draws: list[int], random: Any) -> None:
    """Any tree comes back whatever the order in the file, parents before children."""
    joints = []
    for i, draw in enumerate(draws, 1):
        joints.append((f"j{random.randrange(10**6)}_{i}", f"l{draw % i}", f"l{i}"))
    parts = [link(f"l{i}") for i in range(len(draws) + 1)]
    parts += [joint(name, parent, child) for name, parent, child in joints]
    random.shuffle(parts)
    model = model_of(robot(*parts))
    names = [link_.name for link_ in model.links]
    found = {(j.name, names[j.parent], names[k + 1]) for k, j in enumerate(model.joints)}
    assert found == set(joints)
    assert all(j.parent <= k for k, j in enumerate(model.joints))
    for children in model.children:
        siblings = [model.joints[c].name for c in children]
        assert siblings == sorted(siblings)


@settings(max_examples=60)
@given(st.binary(max_size=60), st.integers(0, 400))
def test_damaged_files_are_refused_or_read(damage: bytes, where: int) -> None:
    data = pair().encode()
    data = data[:where] + damage + data[where + len(damage) :]
    notes = Notes("text")
    try:
        text = data.decode("utf-8", errors="strict")
        describe(parse(text, notes), "text", notes)
    except (InputError, UnicodeDecodeError):
        pass


def test_same_bytes_every_time(read: Read) -> None:
    text = pair(f'<inertial><origin rpy="0.1 0.2 0.3"/>{MASS}{INERTIA}</inertial>')
    one, other = read(text).model, read(text).model
    assert one.links[1].inertia.tensor.tobytes() == other.links[1].inertia.tensor.tobytes()


def test_a_base_with_limbs_that_is_held_is_told(read: Read) -> None:
    legs = [
        joint(f"{side}{k}", f"{side}{k}" if k else "trunk", f"{side}{k + 1}")
        for side in "ab"
        for k in range(3)
    ]
    links = [link("trunk"), *(link(f"{side}{k + 1}") for side in "ab" for k in range(3))]
    text = robot(*links, *legs)
    (warning,) = read(text, held=False).warnings
    assert 'the root link "trunk" (1 kg, 2 limbs) is held fixed: --floating' in warning
    assert read(text).warnings == ()
    assert read(text, held=False, floating=True).warnings == ()
    assert read(robot(*links[:4], *legs[:3]), held=False).warnings == ()  # an arm
    short = [
        joint(f"{s}{k}", f"{s}{k}" if k else "trunk", f"{s}{k + 1}") for s in "abcd" for k in (0, 1)
    ]
    links = [link("trunk"), *(link(f"{s}{k}") for s in "abcd" for k in (1, 2))]
    (warning,) = read(robot(*links, *short), held=False).warnings
    assert "(1 kg, 4 limbs) is held fixed" in warning
    assert read(robot(*links[:5], *short[:4]), held=False).warnings == ()  # a gripper
