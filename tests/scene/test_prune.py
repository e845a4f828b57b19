"""What cannot influence the accelerations that are wanted is left out, and nothing else."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.reference import (
    exact_forward_dynamics,
)
from adagen.scene import apply_scene
from adagen.scene.types import JointScene, Scene
from adagen.states import random_states
from adagen.tomlfile import Source
from tests.models import ALL_KINDS, binary, human_figure, random_tree
from tests.scene.held import held, rows
from tests.scene.texts import reduced

Array = NDArray[np.float64]
SOURCE = Source("s.toml", "")


@settings(max_examples=25)
@given(st.integers(0, 10**6), st.integers(2, 14))
def test_what_is_left_out_has_no_influence(seed: int, n: int) -> None:
    """Wanted accelerations are the same to the bit whatever happens in the limbs left out.

    Those of joints whose motion is prescribed may be wanted, too.
    """
    rng = np.random.default_rng(seed)
    model = random_tree(rng, n, ALL_KINDS)
    known = [j for j in range(n) if rng.random() < 0.4]
    wanted = [j for j in range(n) if rng.random() < 0.3]
    if set(wanted) <= set(known):
        return
    scene = Scene(
        SOURCE,
        accelerations=tuple(model.joints[j].name for j in wanted),
        joints={model.joints[j].name: JointScene(prescribed=True) for j in known},
    )
    reduction = apply_scene(model, scene)
    small, whole = reduction.model, held(model, known)
    left = [j for j, joint in enumerate(model.joints) if joint.name not in reduction.dropped]
    assert [joint.name for joint in small.joints] == [model.joints[j].name for j in left]
    sample = random_states(model, 1, seed=2)
    q, v, tau = sample.q[0], sample.v[0], sample.tau[0]
    want = exact_forward_dynamics(whole, q, v, tau).value
    of, at = rows(model, left), rows(model, left, "q")
    got = exact_forward_dynamics(small, q[at], v[of], tau[of]).value
    spot = {j: k for k, j in enumerate(left)}
    for j in wanted:
        mine = got[rows(small, [spot[j]])]
        np.testing.assert_allclose(mine, want[rows(model, [j])], rtol=1e-14, atol=1e-15)


def test_on_a_floating_base_everything_matters(tmp_path: Path) -> None:
    text = 'accelerations = ["left_ankle"]\n'
    assert reduced(human_figure(), tmp_path, text).dropped == ()


def test_limbs_on_a_fixed_ground_do_not_feel_each_other(tmp_path: Path) -> None:
    model = binary(2)
    reduction = reduced(model, tmp_path, 'accelerations = ["bll"]\n')
    assert [joint.name for joint in reduction.model.joints] == ["bl", "bll", "blr"]
    assert reduction.dropped == ("br", "brl", "brr")
    assert reduction.why_missing("br") == "nothing that the scene wants depends on it"
    assert reduction.why_missing("bl") is None


def test_a_kept_link_keeps_its_limb(tmp_path: Path) -> None:
    model = binary(2)
    text = f'accelerations = ["bll"]\nkeep = ["{model.links[-1].name}"]\n'
    assert reduced(model, tmp_path, text).dropped == ()


def test_a_prescribed_joint_alone_leaves_nothing_to_solve(tmp_path: Path) -> None:
    text = 'accelerations = ["bl"]\n[joints.bl]\nprescribed = true\n'
    with pytest.raises(InputError, match="every joint's acceleration is prescribed"):
        reduced(binary(2), tmp_path, text)
    both = text.replace('"bl"', '"bl", "brl"', 1)
    left = reduced(binary(2), tmp_path, both).model
    assert [joint.name for joint in left.joints] == ["bl", "br", "brl", "brr"]


def test_a_force_that_cannot_matter_is_refused(tmp_path: Path) -> None:
    model = binary(2)
    text = f'accelerations = ["bll"]\nforces = ["{model.links[-1].name}"]\n'
    with pytest.raises(InputError, match=r":2: error: .* changes nothing that the scene asks for"):
        reduced(model, tmp_path, text)
