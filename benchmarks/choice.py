"""What ``--shape auto`` emits beside every shape, as measured: ``python -m benchmarks.choice``.

    python -m benchmarks.choice [--rounds N] [--only NAME ...] [--page] [--out FILE]

Forty robots of example-robot-data on one process and on two. All programs of a robot are built,
then timed by turns: a round runs each once, and the least median of all rounds counts, since other
work on the machine only ever adds to a time. --page writes the table into docs/choice.md; the
record goes to build/choice.json, from which --page alone writes the table again.
"""

from __future__ import annotations

import argparse
import json
import sys
import sysconfig
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median

from adagen.build import Toolchain, find_toolchain
from adagen.calibrate.measure import Program
from adagen.cost import timeline
from adagen.emit.shapes import SHAPES, chosen_shape
from adagen.errors import AdagenError
from adagen.plan import Plan, make_plan
from adagen.program import lower
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.studies.bench.machine import machine
from adagen.urdf import read_robot
from benchmarks.page import write_between_marks

ROOT = Path(__file__).resolve().parents[1]
PAGE, RECORD = ROOT / "docs" / "choice.md", ROOT / "build" / "choice.json"
FASTEST, SLOWEST = 1.05, 1.15
"""Ratios to the fastest shape that nearly all choices, and all, are to keep."""
MOST_TEXT = 2_500_000  # characters of a source: beyond, compilers take minutes

ROBOTS: tuple[tuple[str, str, bool], ...] = (
    ("ur3", "ur_description/urdf/ur3_robot.urdf", False),
    ("ur5", "ur_description/urdf/ur5_robot.urdf", False),
    ("ur10", "ur_description/urdf/ur10_robot.urdf", False),
    ("ur5_gripper", "ur_description/urdf/ur5_gripper.urdf", False),
    ("panda", "panda_description/urdf/panda.urdf", False),
    ("kinova", "kinova_description/robots/kinova.urdf", False),
    ("xarm7", "xarm_description/urdf/xarm7.urdf", False),
    ("z1", "z1_description/urdf/z1.urdf", False),
    ("so100", "so_arm_description/urdf/so100.urdf", False),
    ("talos_left_arm", "talos_data/robots/talos_left_arm.urdf", False),
    ("finger_edu", "finger_edu_description/robots/finger_edu.urdf", False),
    ("double_pendulum", "double_pendulum_description/urdf/double_pendulum.urdf", False),
    ("allegro_right", "allegro_hand_description/urdf/allegro_right_hand.urdf", False),
    ("allegro_left", "allegro_hand_description/urdf/allegro_left_hand.urdf", False),
    ("baxter", "baxter_description/urdf/baxter.urdf", False),
    ("pr2", "pr2_description/urdf/pr2.urdf", False),
    ("tiago", "tiago_description/robots/tiago.urdf", False),
    ("tiago_no_hand", "tiago_description/robots/tiago_no_hand.urdf", False),
    ("tiago_dual", "tiago_description/robots/tiago_dual.urdf", False),
    ("tiago_pro", "tiago_pro_description/urdf/tiago_pro.urdf", False),
    ("a1", "a1_description/urdf/a1.urdf", True),
    ("go1", "go1_description/urdf/go1.urdf", True),
    ("go2", "go2_description/urdf/go2.urdf", True),
    ("b1", "b1_description/urdf/b1.urdf", True),
    ("b1_z1", "b1_description/urdf/b1-z1.urdf", True),
    ("laikago", "laikago_description/urdf/laikago.urdf", True),
    ("anymal_b", "anymal_b_simple_description/robots/anymal.urdf", True),
    ("anymal_kinova", "anymal_b_simple_description/robots/anymal-kinova.urdf", True),
    ("anymal_c", "anymal_c_simple_description/urdf/anymal.urdf", True),
    ("hyq", "hyq_description/robots/hyq_no_sensors.urdf", True),
    ("solo8", "solo_description/robots/solo.urdf", True),
    ("solo12", "solo_description/robots/solo12.urdf", True),
    ("bolt", "bolt_description/robots/bolt.urdf", True),
    ("quadruped", "quadruped_description/urdf/quadruped.urdf", True),
    ("g1", "g1_description/urdf/g1_29dof_rev_1_0.urdf", True),
    ("g1_hands", "g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf", True),
    ("icub", "icub_description/robots/icub.urdf", True),
    ("talos", "talos_data/robots/talos_full_v2.urdf", True),
    ("romeo", "romeo_description/urdf/romeo.urdf", True),
    ("simple_humanoid", "simple_humanoid_description/urdf/simple_humanoid.urdf", True),
)
"""Names, files of the package example-robot-data, whether the base floats."""


@dataclass(frozen=True)
class Case:
    """A robot on a number of processes; times in microseconds.

    Attributes:
        robot: its name.
        freedoms: degrees of freedom.
        processes: P.
        chosen: the shape that ``--shape auto`` emits.
        measured: the time of every shape that could be built.
        predicted: what the shipped profile predicts of each.
    """

    robot: str
    freedoms: int
    processes: int
    chosen: str
    measured: dict[str, float]
    predicted: dict[str, float]

    @property
    def ratio(self) -> float:
        """How much slower than the fastest shape the chosen one is, as a ratio."""
        return self.measured[self.chosen] / min(self.measured.values())


def cases(name: str, path: Path, floating: bool, rounds: int) -> list[Case]:
    """Measure a robot on one process and on two."""
    model, toolchain = read_robot(path, floating=floating).model, find_toolchain()
    profile = load_profile("default")
    plans = {p: make_plan(model, best_schedule(model, p, profile)) for p in (1, 2)}
    programs = {
        (p, shape): program
        for p, plan in plans.items()
        for shape in SHAPES
        if (program := built(plan, toolchain, shape)) is not None
    }
    times: dict[tuple[int, str], list[float]] = {key: [] for key in programs}
    for _ in range(rounds):
        for key, program in programs.items():
            times[key].append(program.measure(repeat=40).time)
    return [
        Case(
            name,
            model.nv,
            p,
            chosen_shape(plan),
            {shape: min(each) for (q, shape), each in times.items() if q == p},
            {
                shape: timeline(lower(plan, shape), profile).makespan
                for q, shape in programs
                if q == p
            },
        )
        for p, plan in plans.items()
    ]


def built(plan: Plan, toolchain: Toolchain, shape: str) -> Program | None:
    """Return a plan's program in a shape; None where it cannot be had, or is not waited for."""
    if shape == "joints" or SHAPES[shape].why_not(plan) is not None:
        return None  # shape joints is written for reading
    try:
        return Program(plan, toolchain, shape, most=MOST_TEXT)
    except AdagenError as error:
        print(f"{plan.name}, {shape}: {error}", file=sys.stderr)
        return None


def table(found: Sequence[Case]) -> str:
    """Return the rows and what they come to, as Markdown."""
    shapes = [shape for shape in SHAPES if any(shape in case.measured for case in found)]
    head = ["robot", "DOF", "P", *(f"{s}, ns" for s in shapes), "auto", "ratio", "predicted, ns"]
    lines = [f"| {' | '.join(head)} |", f"|{'---|' * len(head)}"]
    for case in found:
        times = [_ns(case.measured.get(shape)) for shape in shapes]
        row = [case.robot, str(case.freedoms), str(case.processes), *times, case.chosen]
        row += [f"{case.ratio:.2f}", _ns(case.predicted[case.chosen])]
        lines.append(f"| {' | '.join(row)} |")
    ratios = [case.ratio for case in found]
    near = sum(ratio <= FASTEST for ratio in ratios) / len(ratios)
    off = [case.predicted[s] / case.measured[s] - 1 for case in found for s in case.measured]
    return "\n".join(
        [
            *lines,
            "",
            f"Of {len(found)} choices {near:.0%} take at most {FASTEST} x the fastest shape; the "
            f"largest ratio is {max(ratios):.2f} (asked: 95 %, and {SLOWEST}). Predicted times are "
            f"off by {median(map(abs, off)):.0%} (median).",
        ]
    )


def _ns(time: float | None) -> str:
    return "" if time is None else f"{1e3 * time:.0f}"


def main() -> None:
    """Measure what the command line names."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--only", nargs="*", metavar="NAME", help="these robots")
    parser.add_argument("--page", action="store_true", help="write the table into docs/choice.md")
    parser.add_argument("--kept", action="store_true", help="measure nothing: use the record")
    options = parser.parse_args()
    if not options.kept:
        _measure(options.rounds, options.only)
    record = json.loads(RECORD.read_text(encoding="utf-8"))
    text = table([Case(**case) for case in record["cases"]])
    print(text)
    if options.page:
        where = record["machine"]
        built_by = ", ".join(where["compilers"].values())
        about = f"{where['processor']}, {built_by}; {record['rounds']} rounds by turns."
        write_between_marks(PAGE, "choice", f"{about}\n\n{text}")


def _measure(rounds: int, only: Sequence[str] | None) -> None:
    folder = Path(sysconfig.get_path("purelib"), "cmeel.prefix/share/example-robot-data/robots")
    found: list[Case] = []
    for name, path, floating in ROBOTS:
        if (only and name not in only) or not (folder / path).is_file():
            continue
        try:
            found += cases(name, folder / path, floating, rounds)
        except AdagenError as error:
            print(f"{name} is left out: {error}", file=sys.stderr)
            continue
        for case in found[-2:]:
            print(f"{case.robot} P={case.processes}: {case.measured}", file=sys.stderr)
        record = {"machine": machine(), "rounds": rounds, "cases": list(map(asdict, found))}
        RECORD.parent.mkdir(parents=True, exist_ok=True)
        RECORD.write_text(json.dumps(record, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
