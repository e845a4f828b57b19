"""adagen from Python: read, compile, build, solve."""

from __future__ import annotations

import copy
import hashlib
import inspect
import json
import pickle
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import adagen
from adagen.build import find_toolchain
from adagen.errors import UsageError
from adagen.library.request import Request
from adagen.plan import plan_from_json
from tests.cli.robots import BALL, LINK, write_arm
from tests.emitted import ROUNDING, forward_error
from tests.golden.make_models import MODELS
from tests.library.solvers import ARM, MOBILE, build, states


def test_scene_and_profile_are_in_head_and_plan(tmp_path: Path) -> None:
    scene = tmp_path / "s.toml"
    scene.write_text("gravity = [0, 0, 0]\r\n", newline="")
    made = adagen.compile(adagen.read(ARM, scene=scene))
    files = made.in_folder(tmp_path / "out")
    plan, head = files["arm7_p1.plan.json"], files["arm7_p1.cpp"][:3000]
    origin = json.loads(plan)["made"]
    assert origin["command"][:3] == ["adagen", origin["command"][1], "--scene=../s.toml"]
    inputs = {each["what"]: each for each in origin["inputs"]}
    assert inputs["scene"]["text"].encode() == scene.read_bytes()
    assert 'name = "default"' in inputs["profile default"]["text"]
    for what, each in inputs.items():
        digest = hashlib.sha256(each["text"].encode()).hexdigest()
        assert f"// input     {what}, sha256 {digest}\n" in head
    assert plan_from_json(plan).gravity == plan_from_json(made.files["arm7_p1.plan.json"]).gravity


LONG = np.zeros(12)
"""Arrays of nine numbers lie in it, one over the other."""


class TestRead:
    def test_a_robot_tells_what_it_is(self) -> None:
        robot = adagen.read(MOBILE)
        assert (robot.name, robot.nq, robot.nv) == ("mobile", 14, 13)
        assert robot.joints[0] == "drive"
        assert len(robot.source_hash) == 64

    def test_options_are_those_of_the_command_line(self) -> None:
        moon = adagen.read(ARM, floating=True, gravity=(0, 0, -1.6))
        assert moon.joints[0] == "__base__"
        assert moon.model.gravity.tolist() == [0, 0, -1.6]
        payload = adagen.read(ARM, scene=MODELS / "arm7_payload.toml")
        assert payload.reduction is not None

    def test_what_is_refused_names_file_and_line(self, tmp_path: Path) -> None:
        (tmp_path / "bad.urdf").write_text("<robot name='x'>\n<link/></robot>")
        with pytest.raises(adagen.InputError, match=r"bad\.urdf:2: error: "):
            adagen.read(tmp_path / "bad.urdf")


class TestCompile:
    def test_what_is_compiled_tells_what_it_is(self, arm: adagen.Solver) -> None:
        compiled = arm.compiled
        assert compiled.request == adagen.Request()
        assert compiled.stem == "arm7_p1"
        assert '#include "arm7_p1.h"' in compiled.source
        assert "arm7_p1_solve(" in compiled.header
        assert compiled.predicted is not None
        assert 0.01 < compiled.predicted < 10
        assert compiled.digits is not None
        assert 10 < compiled.digits < 17
        assert compiled.program.processes
        assert compiled.warnings == ()

    def test_what_the_command_line_warns_of_is_told(self, tmp_path: Path) -> None:
        """Idle processes where two do not pay, and a body that spins, in loops."""
        arm = adagen.compile(adagen.read(ARM), procs=2, channel="threads")
        (unpaid,) = arm.warnings
        assert unpaid.startswith("2 processes do not pay: ")
        (tmp_path / "ball.urdf").write_text(BALL)
        ball = adagen.compile(adagen.read(tmp_path / "ball.urdf"), shape="kernels")
        (few,) = ball.warnings
        assert 'digits are predicted; the largest loss is at joint "ball"' in few
        with pytest.warns(UserWarning, match="^ball_p1: .* digits are predicted"):
            ball.build()

    def test_what_cannot_be_solved_is_not_built(self, tmp_path: Path) -> None:
        """A link of 1e-20 kg between two of 1.5 kg, in form ada."""
        light = LINK.format(name="l2")
        for number in ("1.5", "0.02", "0.03", "0.01"):
            light = light.replace(f'="{number}"', f'="{number}e-20"')
        path = write_arm(tmp_path / "arm.urdf")
        path.write_text(path.read_text().replace(LINK.format(name="l2"), light))
        compiled = adagen.compile(adagen.read(path), procs=2, form="ada", channel="threads")
        assert compiled.digits is None
        with pytest.raises(
            adagen.InputError, match=r"arm\.urdf: error: .*no digits left; use --form"
        ):
            compiled.build()

    def test_the_command_line_writes_the_same(self, tmp_path: Path) -> None:
        from adagen.cli import main

        asked = ["--procs", "2", "--shape", "kernels", "--scalar", "float"]
        assert main([str(ARM), *asked, "--out", str(tmp_path / "a")]) == 0
        compiled = adagen.compile(adagen.read(ARM), procs=2, shape="kernels", scalar="float")
        written = compiled.write(tmp_path / "b")
        own = sorted(name for name in compiled.files if "/" not in name)
        assert [path.name for path in written] == sorted([*own, "adagen"])
        for name in compiled.files:
            assert (tmp_path / "b" / name).read_bytes() == (tmp_path / "a" / name).read_bytes()

    @pytest.mark.parametrize(
        ("asked", "said"),
        [
            ({"scalar": "half"}, "scalar is one of double, float, not 'half'"),
            ({"procs": 0}, "procs is from 1 to 1024"),
            ({"scalr": "float"}, "unexpected keyword argument 'scalr'"),
            ({"batch": True, "refine": 1}, "batches are not refined"),
            ({"schedule": "nowhere.json"}, "is neither a file nor one of auto, balanced"),
            ({"naive": True}, "naive is for strategy astar or paper"),
            ({"shape": "joints"}, "for form ada: add --form ada, or take shape kernels or"),
        ],
    )
    def test_what_cannot_be_had_is_told(self, asked: dict[str, Any], said: str) -> None:
        with pytest.raises(adagen.UsageError, match=said):
            adagen.compile(adagen.read(ARM), **asked)

    def test_several_processes_are_no_python_program(self) -> None:
        with pytest.raises(adagen.UsageError, match="arm7_p2 is for 2 processes"):
            build(ARM, procs=2)

    def test_a_missing_compiler_is_told(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setenv("CXX", "no-such-compiler")
        with pytest.raises(adagen.EnvironmentFault, match="no-such-compiler"):
            build(ARM, shape="kernels")


class TestSolve:
    @pytest.mark.parametrize(
        ("path", "asked"),
        [
            (MOBILE, {}),
            (ARM, {"form": "ada", "shape": "joints"}),
            (ARM, {"batch": True}),
            (ARM, {"scalar": "float"}),
        ],
    )
    def test_one_state_and_many_are_right(self, path: Path, asked: dict[str, Any]) -> None:
        solver = build(path, **asked)
        *given, truth = states(solver, 5)
        enough = ROUNDING["float" if asked.get("scalar") == "float" else "double"]
        many = solver(*given)
        assert (many.shape, many.dtype) == (truth.shape, solver.dtype)
        assert forward_error(many, truth) < enough
        for s in range(5):
            one = solver(*(part[s] for part in given))
            assert one.shape == (solver.nv,)
            assert forward_error(one[None], truth[s : s + 1]) < enough

    def test_what_is_given_is_converted(self, arm: adagen.Solver) -> None:
        q, v, tau, _ = states(arm, 4)
        plain = arm(q, v, tau)
        assert np.array_equal(arm(q.tolist(), v=v[::1], tau=np.asfortranarray(tau)), plain)
        wide = np.zeros((8, arm.nq))
        wide[::2] = q
        assert np.array_equal(arm(wide[::2], v.astype(">f8"), tau), plain)
        ones = np.ones(arm.nv, np.int32)
        assert np.array_equal(arm(q[0], ones, tau[0]), arm(q[0], ones.astype(float), tau[0]))

    def test_out_is_filled_and_returned(self, arm: adagen.Solver) -> None:
        q, v, tau, _ = states(arm, 3)
        out = np.empty((3, arm.nv))
        assert arm(q, v, tau, out) is out
        assert np.array_equal(out, arm(q, v, tau))
        assert arm(q[0], v[0], tau[0], out=out[1]).base is out
        assert np.array_equal(out[0], out[1])
        assert arm(q[:0], v[:0], tau[:0]).shape == (0, arm.nv)

    def test_a_failure_names_the_joint_and_writes_nothing(self, arm: adagen.Solver) -> None:
        q, v, tau, _ = states(arm, 4)
        v[2, 3] = np.nan
        out = np.full(arm.nv, 5.0)
        with pytest.raises(adagen.SolveError, match='joint "elbow_pitch": its q, v or') as one:
            arm(q[2], v[2], tau[2], out)
        assert (one.value.joint, one.value.state, one.value.out) == ("elbow_pitch", None, None)
        assert (out == 5).all()
        for solver in (arm, build(ARM, batch=True)):
            with pytest.raises(adagen.SolveError, match=r'^state 2: joint "elbow_pitch"') as many:
                solver(q, v, tau)
            assert (many.value.state, many.value.count) == (2, 1)
            assert np.isnan(many.value.out[2]).all()
            rest = [0, 1, 3]
            assert np.array_equal(many.value.out[rest], solver(q[rest], v[rest], tau[rest]))
            assert str(pickle.loads(pickle.dumps(many.value))) == str(many.value)

    @pytest.mark.parametrize(
        ("spoil", "kind", "said"),
        [
            (lambda x: (x.q[:3], x.v, x.tau), ValueError, r"q has shape \(3,\), not \(9,\)"),
            (lambda x: (x.q, x.v[None], x.tau), ValueError, "v holds 1 states in 2 dimensions"),
            (lambda x: (x.q[None, None], x.v, x.tau), ValueError, r"q has shape \(1, 1, 9\)"),
            (lambda x: (x.q, x.v), TypeError, "tau is missing"),
            (lambda x: (x.q, x.v, x.tau, None, 1), TypeError, "not 5 arguments"),
            (lambda x: (x.q, x.v, x.tau, x.v), ValueError, "out is also what is read"),
            (lambda x: (LONG[:9], x.v, x.tau, LONG[3:]), ValueError, "out is also what is read"),
            (lambda x: (x.q, x.v, LONG[3:], LONG[:9]), ValueError, "out is also what is read"),
            (lambda x: (x.q, x.v, x.tau, x.q[:3].copy()), ValueError, "out must be an array"),
            (lambda x: (x.q, x.v, x.tau, [0.0] * 9), ValueError, "out must be an array"),
            (lambda x: (x.q * 1j, x.v, x.tau), TypeError, "complex128 are no real numbers"),
            (lambda x: ("x", x.v, x.tau), TypeError, "are no real numbers"),
        ],
    )
    def test_what_cannot_be_taken_is_told(
        self,
        spoil: Callable[[SimpleNamespace], tuple[Any, ...]],
        kind: type[Exception],
        said: str,
        arm: adagen.Solver,
    ) -> None:
        q, v, tau, _ = states(arm, 1)
        with pytest.raises(kind, match=said):
            arm(*spoil(SimpleNamespace(q=q[0], v=v[0], tau=tau[0])))
        with pytest.raises(TypeError, match="each once: 'w'"):
            arm(q[0], v[0], tau[0], w=1)  # type: ignore[call-arg]


@pytest.mark.parametrize("batch", [False, True])
def test_what_nobody_asks_for_is_no_number(batch: bool, tmp_path: Path) -> None:
    """The first joint's acceleration is not computed; of the states one cannot be solved."""
    scene = tmp_path / "few.toml"
    scene.write_text('accelerations = ["elbow_pitch"]\n')
    solver = adagen.compile(adagen.read(ARM, scene=scene), batch=batch).build()
    q, v, tau, true = states(solver, 21)
    (wanted,) = np.flatnonzero(~np.isnan(solver(q, v, tau)).all(axis=0))
    assert wanted > 0 and wanted == solver.index("elbow_pitch", of="v")
    tau[5] = np.nan
    with pytest.raises(adagen.SolveError) as failed:
        solver(q, v, tau)
    assert (failed.value.state, failed.value.count) == (5, 1)
    out = np.asarray(failed.value.out)
    assert np.isnan(np.delete(out, wanted, axis=1)).all()
    assert np.flatnonzero(np.isnan(out[:, wanted])).tolist() == [5]
    good = np.delete(np.arange(21), 5)
    assert forward_error(out[good][:, [wanted]], true[good][:, [wanted]]) < ROUNDING["double"]


class TestNames:
    def test_joints_and_their_places(self, mobile: adagen.Solver) -> None:
        assert mobile.joints == adagen.read(MOBILE).joints
        assert (mobile.nq, mobile.nv, mobile.ntau) == (14, 13, 13)
        assert mobile.index("lift") == 4
        assert mobile.index("drive") == slice(0, 3)
        assert mobile.index("loose", of="v") == slice(7, 13)

    def test_pack_puts_all_else_at_rest(self, mobile: adagen.Solver) -> None:
        q = mobile.pack({"lift": 0.2, "drive": [1, 2, 3]})
        assert q.tolist() == [1, 2, 3, 0, 0.2, 0, 0, 0, 0, 0, 0, 0, 0, 1]
        tau = mobile.pack({"shoulder": 4}, of="tau")
        assert tau.shape == (13,)
        assert tau[mobile.index("shoulder", "tau")] == 4

    def test_what_is_unknown_or_of_another_size_is_named(self, mobile: adagen.Solver) -> None:
        with pytest.raises(adagen.JointError, match=r'no joint "lft" \(did you mean "lift"\?\)'):
            mobile.index("lft")
        with pytest.raises(LookupError):
            mobile.pack({"elbow": 0})
        with pytest.raises(ValueError, match='joint "loose" has 7 numbers in q, not shape'):
            mobile.pack({"loose": 1})
        with pytest.raises(adagen.UsageError, match="of is q, v or tau"):
            mobile.pack({}, of="a")  # type: ignore[arg-type]


class TestObjects:
    def test_solvers_pickle_and_copy(self, arm: adagen.Solver) -> None:
        *given, _ = states(arm, 2)
        for other in (pickle.loads(pickle.dumps(arm)), copy.copy(arm), copy.deepcopy(arm)):
            assert other is not arm and other == arm and hash(other) == hash(arm)
            assert np.array_equal(other(*given), arm(*given))
            assert other.compiled.request == arm.compiled.request

    @pytest.mark.parametrize("batch", [False, True])
    def test_a_copy_has_the_same_bits(
        self, batch: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        """Inertias that can be set are computed as they are when they are set.

        Of numbers whose products are rounded: a compiler that knew them would round differently,
        if it optimises as it usually does.
        """
        monkeypatch.delenv("CXXFLAGS", raising=False)
        rng = np.random.default_rng(3)
        text = ARM.read_text(encoding="utf-8")
        mass, origin = r'(<mass value=")[^"]*', r'(<inertial>\s*<origin xyz=")[^"]*'
        text = re.sub(mass, lambda m: f"{m[1]}{rng.uniform(1, 5):.15g}", text)
        at = rng.uniform(-0.1, 0.1, (20, 3)).tolist()
        text = re.sub(origin, lambda m: m[1] + " ".join(map(str, at.pop())), text)
        odd = tmp_path / "arm.urdf"
        odd.write_text(text, encoding="utf-8")
        asked = {"shape": "kernels", "runtime": "mass:turret,mass:hand", "batch": batch}
        solver = build(odd, **asked)
        given = states(solver, 64)[:3]
        expected = solver(*given)
        np.testing.assert_array_equal(copy.copy(solver)(*given), expected)
        solver.set_mass("hand", solver.compiled.plan.parameter_values[-1])
        np.testing.assert_array_equal(solver(*given), expected)

    def test_a_copy_is_of_the_same_build(self) -> None:
        found = find_toolchain()
        flags = tuple("-O1" if flag == "-O3" else flag for flag in found.flags)
        solver = adagen.compile(adagen.read(ARM)).build(replace(found, flags=flags))
        assert flags != found.flags
        assert type(copy.copy(solver)) is type(copy.deepcopy(solver)) is type(solver)

    def test_a_pickle_is_equal_to_its_original(self) -> None:
        robot = adagen.read(ARM)
        made = adagen.compile(robot, procs=1, runtime="gravity", shape="kernels")
        assert made.digits is not None  # what is found later does not count
        again = pickle.loads(pickle.dumps(made))
        assert again == made and hash(again) == hash(made) and again is not made
        assert again.request == made.request and again.files == made.files
        assert again.build() == made.build()
        others = (
            adagen.compile(robot, procs=1, shape="kernels"),
            adagen.compile(robot, procs=1, runtime="gravity", shape="unrolled"),
            adagen.compile(adagen.read(ARM, gravity=(0, 0, -1)), procs=1, runtime="gravity"),
        )
        for other in others:
            assert other != made
        assert made != made.request

    def test_what_is_set_at_run_time_makes_solvers_differ(self) -> None:
        made = adagen.compile(adagen.read(ARM), procs=1, runtime="gravity", shape="kernels")
        one, other = made.build(), made.build()
        assert one == other
        other.gravity = (0, 0, -1.62)
        assert one != other and other == pickle.loads(pickle.dumps(other))
        assert hash(one) == hash(other)

    def test_a_pickle_works_in_another_process(self, arm: adagen.Solver, tmp_path: Path) -> None:
        *given, _ = states(arm, 2)
        (tmp_path / "pickle").write_bytes(pickle.dumps((arm, given, arm(*given))))
        program = (
            "import pickle, sys; f, given, found = pickle.load(open(sys.argv[1], 'rb'));"
            "print((f(*given) == found).all())"
        )
        done = subprocess.run(
            [sys.executable, "-c", program, str(tmp_path / "pickle")],
            capture_output=True,
            text=True,
            timeout=60,
        )
        assert (done.stdout, done.stderr) == ("True\n", "")

    def test_types_and_docstrings_are_there(self, arm: adagen.Solver) -> None:
        assert isinstance(arm, adagen.Solver)
        assert "(S, nq)" in (type(arm).__doc__ or "")
        for name in adagen.__all__:
            assert inspect.getdoc(getattr(adagen, name)), name
            assert name in dir(adagen)
        with pytest.raises(AttributeError, match="no attribute 'nothing'"):
            _ = adagen.nothing

    def test_the_command_line_starts_without_it(self) -> None:
        program = "import sys, adagen.cli; print('adagen.library' in sys.modules)"
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        assert done.stdout == "False\n"


def test_reproducible_solvers_are_for_hosts() -> None:
    with pytest.raises(UsageError, match="reproducible solvers are not emitted with --target"):
        Request(reproducible=True, target="embedded")
