"""The states file: what is read back, and what every mistake in it gets."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.errors import EnvironmentFault, InputError
from adagen.model import PLANAR, PRISMATIC, REVOLUTE, Model
from adagen.states import (
    States,
    StatesFile,
    random_states,
    read_result,
    read_states,
    write_states,
)
from tests.models import human_figure, random_tree, serial_chain
from tests.results import write_result

Document = dict[str, Any]


@pytest.fixture
def model() -> Model:
    """A floating base, spherical and revolute joints."""
    return human_figure()


@pytest.fixture
def document(model: Model, tmp_path: Path) -> Document:
    """A right states file of two states."""
    path = tmp_path / "right.json"
    write_states(random_states(model, 2, 1), model, path)
    result: Document = json.loads(path.read_text())
    return result


def written(folder: Path, content: Document | str) -> Path:
    path = folder / "states.json"
    path.write_text(content if isinstance(content, str) else json.dumps(content))
    return path


@pytest.mark.parametrize("seed", range(4))
def test_states_read_back_bit_by_bit(seed: int, tmp_path: Path) -> None:
    model = random_tree(np.random.default_rng(seed), 12, floating=bool(seed % 2), mimics=2)
    states = random_states(model, 3, seed)
    write_states(states, model, tmp_path / "s.json")
    back = read_states(tmp_path / "s.json", model)
    for one, other in ((states.q, back.q), (states.v, back.v), (states.tau, back.tau)):
        np.testing.assert_array_equal(one, other)
    assert back.count == 3
    gravity = StatesFile.read(tmp_path / "s.json").gravity
    assert gravity is not None
    np.testing.assert_array_equal(gravity, model.gravity)


def test_result_reads_back_bit_by_bit(model: Model, tmp_path: Path) -> None:
    qdd = np.random.default_rng(0).normal(size=(3, model.nv)) * 1e7
    write_result(tmp_path / "r.json", model, qdd)
    np.testing.assert_array_equal(read_result(tmp_path / "r.json", model), qdd)


def test_a_folder_that_is_missing(model: Model, tmp_path: Path) -> None:
    with pytest.raises(EnvironmentFault, match="cannot write"):
        write_states(random_states(model, 1, 1), model, tmp_path / "none" / "s.json")


def test_random_states_are_repeatable_and_possible(model: Model) -> None:
    one, same, other = (random_states(model, 50, seed) for seed in (7, 7, 8))
    np.testing.assert_array_equal(one.q, same.q)
    np.testing.assert_array_equal(one.tau, same.tau)
    assert (one.v != other.v).all()
    for joint, start in zip(model.joints, model.q_start, strict=True):
        own = one.q[:, start : start + joint.kind.nq]
        if joint.kind.quaternion is not None:
            np.testing.assert_allclose(np.linalg.norm(own[:, -4:], axis=1), 1, rtol=1e-15)
        else:
            assert np.abs(own).max() > 2  # angles use the whole circle
            assert np.abs(own).max() <= np.pi


def test_random_lengths_are_within_a_metre() -> None:
    rng = np.random.default_rng(0)
    states = random_states(random_tree(rng, 5, [PRISMATIC]), 100)
    assert np.abs(states.q).max() <= 1
    planar = random_states(random_tree(rng, 1, [PLANAR]), 100).q
    assert np.abs(planar[:, :2]).max() <= 1
    assert np.abs(planar[:, 2]).max() > 2


def test_a_number_or_a_list_of_one(tmp_path: Path) -> None:
    model = serial_chain(2)
    joints = {
        "j000": {"q": [1, [2.5]], "v": [0, 0], "tau": [[0], -1e-3], "type": "revolute"},
        "j001": {"tau": [0, 0], "v": [0, 0], "q": [3, 4], "qdd": [1, 2]},
    }
    states = read_states(written(tmp_path, {"joints": joints}), model)
    np.testing.assert_array_equal(states.q, [[1, 3], [2.5, 4]])
    np.testing.assert_array_equal(states.tau, [[0, 0], [-1e-3, 0]])
    assert StatesFile.read(tmp_path / "states.json").gravity is None


def test_files_of_true_answers_are_states(shared: Path, tmp_path: Path) -> None:
    """The members of a truth file's mode, given as they are."""
    mode = json.loads((shared / "param" / "sem_single_rev.json").read_text())["modes"]["fixed"]
    model = serial_chain(1)
    name = model.joints[0].name
    document = {"floating": False, "joints": {name: mode["joints"]["j"]}}
    assert read_states(written(tmp_path, document), model).count == 5


def change(*path: Any, to: Any) -> Callable[[Document], None]:
    def apply(document: Document) -> None:
        place: Any = document
        for step in path[:-1]:
            place = place[step]
        place[path[-1]] = to

    return apply


def drop(*path: Any) -> Callable[[Document], None]:
    def apply(document: Document) -> None:
        place: Any = document
        for step in path[:-1]:
            place = place[step]
        del place[path[-1]]

    return apply


KNEE = ("joints", "left_knee")
MISTAKES = [
    (change("joints", "left_kne", to={}), "'left_kne' is not a moving joint.*mean 'left_knee'"),
    (drop("joints", "left_knee"), "'left_knee' is missing"),
    (drop("joints", "__base__"), "'__base__' is missing.*--floating"),
    (drop(*KNEE, "tau"), "'left_knee': tau is missing"),
    (change(*KNEE, "torque", to=[0, 0]), "'left_knee': unknown member 'torque'"),
    (change(*KNEE, "v", to=[0]), "'left_knee': v has 1 states, the first joint has 2"),
    (change(*KNEE, "v", to=3.0), "'left_knee': v is not a list"),
    (change(*KNEE, "v", 1, to=[1, 2]), "'left_knee': v, state 1: 2 numbers.*a number"),
    (change("joints", "waist", "v", 0, to=1.0), "'waist': v, state 0: 1 numbers.*list of 3"),
    (change("joints", "waist", "q", 0, to=[0, 0, 1]), "'waist': q, state 0: 3 numbers.*of 4"),
    (change("joints", "waist", "q", 1, to=[0, 0, 0, 0]), "'waist': q, state 1.*zero.*x, y, z, w"),
    (change("joints", "waist", "q", 1, to=[0, 0, 0, 1.01]), "length 1.01, not 1.*x, y, z, w"),
    (change("joints", "__base__", "q", 0, to=[0, 0, 0, 9, 0, 0, 0]), "'__base__'.*length 9"),
    (change(*KNEE, "q", 0, to="1.0"), "'left_knee': q, state 0: \"1.0\" is not a number"),
    (change(*KNEE, "q", 0, to=True), "true is not a number"),
    (change(*KNEE, "q", 0, to=None), "null is not a number"),
    (change(*KNEE, "q", 0, to=10**400), "too large"),
    (change(*KNEE, to=[1, 2]), "'left_knee' is not an object"),
    (change("floating", to=False), "fixed base"),
    (change("floating", to="yes"), "'floating' is neither"),
    (change("gravity", to=[0, 0]), "'gravity' is not three numbers"),
    (change("gravity", to=[0, 0, "g"]), "'gravity': \"g\" is not a number"),
    (change("gravty", to=[0, 0, 0]), "unknown member 'gravty'; did you mean 'gravity'"),
    (drop("joints"), "'joints' is missing"),
    (change("joints", to={}), "is missing"),
    (change("joints", to=[]), "'joints' is not an object"),
]


@pytest.mark.parametrize(("mistake", "message"), MISTAKES)
def test_mistakes(
    mistake: Callable[[Document], None],
    message: str,
    document: Document,
    model: Model,
    tmp_path: Path,
) -> None:
    read_states(written(tmp_path, document), model)
    mistake(document)
    with pytest.raises(InputError, match=message) as caught:
        read_states(written(tmp_path, document), model)
    assert str(caught.value).startswith(f"{tmp_path / 'states.json'}: error: ")
    assert "\n" not in str(caught.value)


TEXTS = [
    ("", 1, "not JSON"),
    ('{"joints":\n {"a": [1,\n 2,,]}}', 3, "not JSON"),
    ('{"joints":\n {"NaN": {"q": [1,\n NaN]}}}', 3, "NaN is neither"),
    ('{"joints":\n {"a": [-Infinity]}}', 2, "-Infinity is neither"),
    ('{"joints": {"a": 1e999}}', None, "not an object|not a moving"),
    ('{"joints": {"a": ' + "9" * 5000 + "}}", None, "too many digits"),
    ('{"joints": {"j000": {}, "j000": {}}}', None, "'j000' is there twice"),
    ("[" * 100000, None, "nested too deeply"),
    ("[]", None, "not an object"),
    ('{"joints": {"j000": {"q": [], "v": [], "tau": []}}}', None, "no states"),
    ('{"joints": {"j000": {"q": [1e999], "v": [0], "tau": [0]}}}', None, "too large"),
    ('{"joints": {"j\\n000": {}}}', None, r"j\\n000"),
]


@pytest.mark.parametrize(("text", "line", "message"), TEXTS, ids=range(len(TEXTS)))
def test_texts(text: str, line: int | None, message: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        read_states(written(tmp_path, text), serial_chain(1))
    place = f"{tmp_path / 'states.json'}:" + ("" if line is None else f"{line}:")
    assert str(caught.value).startswith(f"{place} error: ")
    assert any(part in str(caught.value) for part in message.replace("\\\\", "\\").split("|"))
    assert len(str(caught.value)) < 400 + len(str(tmp_path))
    assert "\n" not in str(caught.value)


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot read"):
        read_states(tmp_path / "none.json", serial_chain(1))
    with pytest.raises(InputError, match="cannot read"):
        StatesFile.read(tmp_path)
    (tmp_path / "binary").write_bytes(b"\x89PNG\xff")
    with pytest.raises(InputError, match="not UTF-8"):
        StatesFile.read(tmp_path / "binary")


def test_a_floating_state_for_a_fixed_robot(tmp_path: Path) -> None:
    joint = {"q": [0], "v": [0], "tau": [0]}
    floating = {"floating": True, "joints": {"j000": joint}}
    with pytest.raises(InputError, match="add --floating"):
        read_states(written(tmp_path, floating), serial_chain(1))
    base = {"joints": {"j000": joint, "__base__": {}}}
    with pytest.raises(InputError, match="base is fixed"):
        read_states(written(tmp_path, base), serial_chain(1))


class TestSlaved:
    @pytest.fixture
    def model(self) -> Model:
        model = random_tree(np.random.default_rng(3), 8, [REVOLUTE, PRISMATIC], mimics=3)
        assert sum(joint.mimic is not None for joint in model.joints) == 3
        return model

    def test_may_be_absent(self, model: Model, tmp_path: Path) -> None:
        states = random_states(model, 2, 5)
        write_states(states, model, tmp_path / "s.json")
        document = json.loads((tmp_path / "s.json").read_text())
        for joint in model.joints:
            if joint.mimic is not None:
                del document["joints"][joint.name]
        back = read_states(written(tmp_path, document), model)
        np.testing.assert_array_equal(back.q, states.q)
        np.testing.assert_array_equal(back.v, states.v)
        for joint, at in zip(model.joints, model.v_start, strict=True):
            if joint.mimic is not None:
                source = states.q[:, model.q_start[joint.mimic.source]]
                expected = source * joint.mimic.multiplier + joint.mimic.offset
                np.testing.assert_allclose(back.q[:, at], expected, rtol=1e-15)
                assert (back.tau[:, at] == 0).all()

    @pytest.mark.parametrize("field", ["q", "v"])
    def test_must_agree(self, field: str, model: Model, tmp_path: Path) -> None:
        write_states(random_states(model, 2, 5), model, tmp_path / "s.json")
        document = json.loads((tmp_path / "s.json").read_text())
        follower = next(joint.name for joint in model.joints if joint.mimic is not None)
        document["joints"][follower][field][1] += 1e-12
        read_states(written(tmp_path, document), model)
        document["joints"][follower][field][1] += 1e-3
        with pytest.raises(InputError, match=f"'{follower}': {field}, state 1: .* its mimic of"):
            read_states(written(tmp_path, document), model)


@pytest.mark.parametrize(
    ("joints", "message"),
    [
        ({"j000": {"qdd": [1, 2]}}, "'j001' is missing"),
        ({"j000": {"qdd": [1, 2]}, "j001": {"qdd": [1]}}, "has 1 states"),
        ({"j000": {"qdd": [1]}, "j001": {}}, "qdd is missing"),
        ({"j000": {"qdd": [1]}, "j001": {"qdd": ["x"]}}, "not a number"),
    ],
)
def test_results_are_read_strictly(joints: Document, message: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=message):
        read_result(written(tmp_path, {"joints": joints}), serial_chain(2))


def test_states_are_counted() -> None:
    assert States(np.zeros((4, 2)), np.zeros((4, 2)), np.zeros((4, 2))).count == 4
