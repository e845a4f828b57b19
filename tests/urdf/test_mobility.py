"""Structurally singular robots, told by the articulated recursion and by the whole matrix."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from flint import ctx

from adagen.model import PRISMATIC, REVOLUTE, Inertia, canonical
from adagen.reference import joint_space_inertia
from adagen.urdf import Reading
from adagen.urdf.bodies import build, gather
from adagen.urdf.description import describe
from adagen.urdf.document import parse
from adagen.urdf.mobility import BITS, weakest
from adagen.urdf.notes import Notes
from adagen.urdf.slaved import inertia_matrix, weakest_slaved
from adagen.urdf.tree import make_tree
from tests.links import with_inertia
from tests.models import random_tree
from tests.urdf.texts import MASS, Y, chain, joint, link, robot

Read = Callable[..., Reading]
Refusal = Callable[..., str]
X, Z = '<axis xyz="1 0 0"/>', '<axis xyz="0 0 1"/>'
HERE = '<origin xyz="0 0 0"/>'
POINT = f'<inertial>{MASS}<inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial>'


def ball(*axes: str, tilt: str = "0 0 0") -> str:
    """Revolute joints through one point with massless links between, as a ball joint is written."""
    n = len(axes)
    parts = [link("l0")]
    for i, axis in enumerate(axes, 1):
        parts.append(link(f"l{i}") if i == n else link(f"l{i}", ""))
        origin = f'<origin xyz="0 0 0" rpy="{tilt}"/>'
        parts.append(joint(f"j{i}", f"l{i - 1}", f"l{i}", "revolute", axis, origin))
    return robot(*parts)


def test_three_axes_through_massless_links_are_regular(read: Read) -> None:
    assert read(ball(X, Y, Z)).model.nv == 3
    assert read(ball(Z, X, Z)).model.nv == 3  # singular at q = 0 only


def test_coaxial_joints_with_nothing_between(refusal: Refusal) -> None:
    said = refusal(ball(Y, Y))
    assert 'joint "j1" can move together with "j2"' in said
    assert 'link "l1"' in said


def test_coaxial_up_to_the_rounding_of_a_rotation(refusal: Refusal) -> None:
    # OwnAxes about the axis that both share: the product of rounded rotations is not exact.
    said = refusal(ball(Z, Z, tilt="0 0 0.7"))
    assert 'joint "j1" can move together with "j2"' in said


def test_four_axes_through_one_point(refusal: Refusal) -> None:
    said = refusal(ball(X, Y, Z, X))
    assert 'joint "j1" can move together with "j2", "j3", "j4"' in said


def test_a_massless_subtree(refusal: Refusal) -> None:
    text = robot(
        link("a"), link("b", ""), link("c", ""), joint("j1", "a", "b"), joint("j2", "b", "c")
    )
    assert 'joint "j2" moves no mass' in refusal(text)


def test_a_file_of_kinematics_alone(refusal: Refusal) -> None:
    text = robot(
        link("a", ""), link("b", ""), link("c", ""), joint("j1", "a", "b"), joint("j2", "b", "c")
    )
    for floating in (False, True):
        said = refusal(text, floating=floating)
        assert said.startswith("robot.urdf:2: error: no link has mass or inertia")


def test_point_masses(read: Read, refusal: Refusal) -> None:
    pendulum = robot(
        link("a", ""), link("b", POINT.replace(MASS, '<origin xyz="0 0 1"/>' + MASS)),
        joint("j1", "a", "b"),
    )  # fmt: skip
    assert read(pendulum).model.nv == 1
    on_axis = robot(link("a", ""), link("b", POINT), joint("j1", "a", "b"))
    assert 'joint "j1" moves no mass' in refusal(on_axis)


def test_a_floating_point_mass_does_not_resist_turning(refusal: Refusal) -> None:
    assert "the floating base moves no mass" in refusal(robot(link("a", POINT)), floating=True)


def test_a_massless_base_with_one_child(read: Read, refusal: Refusal) -> None:
    text = robot(link("base", ""), link("b"), joint("j1", "base", "b"))
    assert read(text).model.nv == 1
    said = refusal(text, floating=True)
    assert said.startswith("robot.urdf:3: error: the floating base can move together with")
    assert '"j1"' in said
    assert 'link "base"' in said


def test_negative_effective_inertia(refusal: Refusal) -> None:
    # Each body passes for rounding noise beside m l^2, but nothing else resists the joint.
    noise = '<inertia ixx="1e-3" ixy="0" ixz="0" iyy="-1e-14" iyz="0" izz="1e-3"/>'
    text = robot(link("a"), link("b", f"<inertial>{MASS}{noise}</inertial>"), joint("j", "a", "b"))
    assert 'joint "j"' in refusal(text)


@pytest.mark.parametrize("scale", ["1e-12", "1e-6", "1e6", "1e12"])
def test_units_do_not_matter(scale: str, read: Read) -> None:
    moments = " ".join(f'i{k}="{scale}"' for k in ("xx", "yy", "zz"))
    body = (
        f'<inertial><mass value="{scale}"/><inertia ixy="0" ixz="0" iyz="0" {moments}/></inertial>'
    )
    text = robot(link("a", ""), link("b", body), link("c", body), joint("j1", "a", "b"),
                 joint("j2", "b", "c"))  # fmt: skip
    assert read(text).model.nv == 2
    assert read(text).warnings == ()


def test_nearly_massless_is_accepted_with_a_warning(read: Read) -> None:
    tip = '<inertial><mass value="0"/><inertia ixy="0" ixz="0" iyz="0" ixx="1e-13" iyy="1e-13" '
    tip += 'izz="1e-13"/></inertial>'
    # l1 carries 1e-13 of its own inertia while l2 is turned about the same axis
    text = ball(Y, Y).replace('<link name="l1"></link>', f'<link name="l1">{tip}</link>')
    warnings = read(text).warnings
    assert any('joint "j1" moves hardly any mass of its own' in w for w in warnings)


@pytest.mark.parametrize("seed", range(6))
def test_the_pivots_are_those_of_the_inertia_matrix(seed: int) -> None:
    """Recursion and dense elimination, two algorithms, agree in the weakest ratio."""
    rng = np.random.default_rng(seed)
    model = random_tree(rng, 12, (REVOLUTE, PRISMATIC), floating=False)
    one, other = weakest(model), weakest_slaved(model)
    assert (one.joint, one.moving) == (other.joint, other.moving)
    assert one.ratio == pytest.approx(other.ratio, rel=1e-12)


@pytest.mark.parametrize("seed", range(8))
def test_both_ways_find_the_same_robots_singular(seed: int) -> None:
    """All kinds of joints, every third link without mass."""
    rng = np.random.default_rng(seed)
    model = random_tree(rng, 6, floating=seed % 2 == 0)
    for i in range(1 + seed % 3, len(model.links), 3):
        model = with_inertia(model, i, Inertia.zero())
    assert weakest(model).singular == weakest_slaved(model).singular


def test_the_inertia_matrix_is_that_of_the_reference(read: Read) -> None:
    """At q = 0 but for the offsets that the generic configuration adds: traces of both shapes."""
    model = canonical(read(chain(5)).model)
    with ctx.workprec(BITS):
        h = inertia_matrix(model, 0)
    found = np.array([[float(h[i, k]) for k in range(5)] for i in range(5)])
    from adagen.urdf.mobility import _generic

    q = np.array([2.5 * _generic(j, 0, 0) for j in range(5)])
    assert found == pytest.approx(joint_space_inertia(model, q), rel=1e-12)


def test_thousands_of_joints_take_bounded_time_and_no_recursion() -> None:
    notes = Notes("chain")
    description = describe(parse(chain(3000), notes), "chain", notes)
    bodies = gather(description, make_tree(description, notes), floating=False)
    model = build("chain", bodies, {}, floating=False)
    assert not weakest(model).singular
