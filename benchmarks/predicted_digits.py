"""Predicted digits beside what emitted solvers lose, over a corpus of robots.

    python -m benchmarks.predicted_digits [--states 64] [--only WORD] [--again PAGE]
                                          [--write docs/records/digits.md]

Each robot as loops and as a straight line on one process, as loops in float, and on two processes
as scheduled by default. Measured is the forward error in the energy norm, sqrt(e^T H e / t^T H t),
against certified digits in the worst of the suite's state and those that the program's --check
draws, which a sweep in more digits than the solver's finds; predicted is what `adagen schedule`
says of plan and shape.
The ratio is measured over predicted: above 1 the
prediction was too optimistic. With --again, nothing is built: what a page's table says was measured
stands beside what is predicted now.
"""

from __future__ import annotations

import argparse
import platform
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from adagen.errors import AdagenError
from adagen.executor.program_states import program_states
from adagen.executor.trial import accelerations
from adagen.library import Origin
from adagen.library.robot import read_whole
from adagen.model import Inertia, Model
from adagen.plan import Plan, make_plan
from adagen.reference import energy_norm_error, joint_space_inertia
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.search.objective import predicted_digits
from adagen.states import States
from adagen.studies.bench.report import table
from adagen.studies.stability import robots
from adagen.studies.truth import DOUBLE, truth_of
from benchmarks.emitted_digits import light_wrists, slender_tool
from benchmarks.page import MODELS, command, publish
from benchmarks.real_robots import DATA
from benchmarks.solvers import answers, tell
from tests.models import human_figure, motion_capture_figure, random_tree, serial_chain, star

Array = NDArray[np.float64]
URDFS = (
    *("icub_description/robots/icub.urdf", "human_description/robots/human.urdf"),
    *("talos_data/robots/talos_reduced.urdf", "panda_description/urdf/panda.urdf"),
    *("allegro_hand_description/urdf/allegro_left_hand.urdf", "ur_description/urdf/ur5_robot.urdf"),
    *("solo_description/robots/solo12.urdf", "kinova_description/robots/kinova.urdf"),
    *("g1_description/urdf/g1_29dof_rev_1_0.urdf", "go2_description/urdf/go2.urdf"),
    *("baxter_description/urdf/baxter.urdf", "so_arm_description/urdf/so101.urdf"),
)
WAYS = (  # processes, shape, scalar
    (1, "kernels", "double"),
    (1, "unrolled", "double"),
    (1, "kernels", "float"),
    (2, "kernels", "double"),
)
MOST_UNROLLED = 40  # degrees of freedom: longer lines take long to compile
HALF_A_DECADE = 10**0.5


@dataclass(frozen=True)
class Row:
    """A program: robot, processes, shape, scalar, and its errors."""

    robot: str
    processes: int
    shape: str
    scalar: str
    predicted: float
    measured: float

    @property
    def ratio(self) -> float:
        """Measured over predicted."""
        return self.measured / self.predicted


def example(path: Path, floating: bool = False) -> Model:
    """Return the robot of a URDF."""
    return read_whole(Origin(path, floating, False, False, None, None))[0].model


def light_tree(seed: int) -> Model:
    """Return a random tree of 12 joints whose links' masses are spread over eight decades."""
    rng = np.random.default_rng(seed)
    model = random_tree(rng, 12)
    links = [
        type(link)(
            link.name, Inertia(m * link.inertia.mass, link.inertia.com, m * link.inertia.tensor)
        )
        for link, m in zip(model.links, 10.0 ** rng.uniform(-8, 0, len(model.links)), strict=True)
    ]
    return Model(f"light_tree{seed}", tuple(links), model.joints)


def corpus() -> Iterator[tuple[str, Callable[[], Model]]]:
    """Yield names of robots, and what makes them."""
    for path in sorted(MODELS.glob("*.urdf")):
        yield path.stem, lambda path=path: example(path)  # type: ignore[misc]
    for name in URDFS:
        if (DATA / name).exists():
            yield Path(name).stem, lambda path=DATA / name: example(path)  # type: ignore[misc]
    if (DATA / URDFS[0]).exists():
        yield "icub, floating", lambda: example(DATA / URDFS[0], True)
    for seed in range(8):
        rng = np.random.default_rng(seed)
        size = int(rng.integers(4, 20))
        yield f"random tree {seed}", lambda r=rng, n=size: random_tree(r, n)  # type: ignore[misc]
    for seed in range(8):
        yield f"masses over 8 decades {seed}", lambda seed=seed: light_tree(seed)  # type: ignore[misc]
    yield "human figure", human_figure
    yield "motion capture", motion_capture_figure
    yield "star", lambda: star(4, 3, floating=True)
    yield "chain of 20", lambda: serial_chain(20)
    yield "chain of 60", lambda: serial_chain(60)
    yield "30 rods", lambda: robots.rods(30)
    yield "100 rods", lambda: robots.rods(100)
    yield "a link of 1e-8 kg", lambda: robots.with_mass(30, 15, 1e-8)
    yield "a tip of 1e4 kg", lambda: robots.with_mass(30, 30, 1e4)
    yield "a tip of 1e8 kg", lambda: robots.with_mass(30, 30, 1e8)
    yield "graded by 1e8", lambda: robots.graded(30, 1e8)
    yield "graded by 1e-8", lambda: robots.graded(30, 1e-8)
    yield "slender rods", lambda: robots.rods(30, radius=5e-4)
    yield "slender tool", lambda: slender_tool(2e-6)
    yield "coil of 50", lambda: robots.coil(50)
    yield "dill of level 4", lambda: robots.dill(4)
    yield "30 ball joints", lambda: robots.spherical_rods(30)
    yield "three axes x 10", lambda: robots.three_axis(10)
    yield "light wrists x 40", light_wrists


def rows_of(name: str, model: Model, count: int) -> Iterator[Row]:
    """Yield a robot's rows; ways that are refused are left out."""
    for processes, shape, scalar in WAYS:
        if shape == "unrolled" and model.nv > MOST_UNROLLED:
            continue
        try:
            plan = _planned(model, processes, scalar)
            predicted = predicted_digits("both", model, plan, shape).error
            states = robots.states_with(model, States(*program_states(plan, count)))
            found = answers(plan, model, states, shape=shape).qdd
        except (AdagenError, FloatingPointError, RuntimeError) as error:
            tell(f"{name}, {processes}, {shape}, {scalar}: {error}")
            continue
        yield Row(name, processes, shape, scalar, predicted, largest(model, plan, states, found))


def predicted_again(page: Path, word: str) -> Iterator[Row]:
    """Yield the rows of a page's table with what is predicted now; measured is as it was."""
    makers, models = dict(corpus()), dict[str, Model]()
    for line in page.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("| ").split("|")]
        if len(cells) != 7 or cells[0] not in makers or word not in cells[0]:
            continue
        name, processes, shape, scalar = cells[0], int(cells[1]), cells[2], cells[3]
        model = models[name] if name in models else models.setdefault(name, makers[name]())
        plan = _planned(model, processes, scalar)
        predicted = predicted_digits("both", model, plan, shape).error
        yield Row(name, processes, shape, scalar, predicted, float(cells[5]))


def _planned(model: Model, processes: int, scalar: str) -> Plan:
    schedule = best_schedule(model, processes, load_profile("default"), "segment", scalar)
    return make_plan(model, schedule, form="segment", scalar=scalar)


def largest(model: Model, plan: Plan, states: States, found: Array) -> float:
    """Return the certified error of the answer that is farthest off."""
    inertia = [joint_space_inertia(model, q) for q in states.q]
    about = accelerations(plan, *states.parts)
    rough = zip(inertia, found, about.astype(np.float64), strict=True)
    s = int(np.argmax([energy_norm_error(h, x - t, t) for h, x, t in rough]))
    one = states.some(slice(s, s + 1))
    return min(1.0, truth_of(model, one, digits=DOUBLE).errors(found[s : s + 1]).forward)


def page(rows: list[Row], count: int) -> str:
    """Return the page: what share of predictions is how far off, and all rows."""
    ratios = np.array([row.ratio for row in rows])
    within = np.mean((ratios > 0.1) & (ratios < 10))
    worst = np.log10(ratios.max())
    too_few = int((ratios > HALF_A_DECADE).sum())
    rows_of_page = [
        (
            *(row.robot, row.processes, row.shape, row.scalar, f"{row.predicted:.1e}"),
            *(f"{row.measured:.1e}", f"{row.ratio:.2f}"),
        )
        for row in rows
    ]
    lines = [
        f"The suite's state and {count} of `--check`, {platform.machine()}, "
        f"`python -m benchmarks.predicted_digits --states {count}`",
        "",
        f"{len(rows)} programs: {within:.0%} within a decade; {too_few} more than half a decade "
        f"too optimistic, the worst by {worst:.2f} decades; median of measured over predicted "
        f"{np.median(ratios):.2f}.",
        "",
        *table(("robot", "P", "shape", "scalar", "predicted", "measured", "ratio"), rows_of_page),
    ]
    return "\n".join(lines)


def _rows(options: argparse.Namespace) -> Iterator[Row]:
    if options.again is not None:
        yield from predicted_again(options.again, options.only)
        return
    for name, make in corpus():
        if options.only in name:
            yield from rows_of(name, make(), options.states)


def main() -> None:
    """Print the table, or put it into a document."""
    parser = command(__doc__)
    parser.add_argument("--states", type=int, default=64)
    parser.add_argument("--only", default="", metavar="WORD", help="robots whose name has it")
    parser.add_argument("--again", type=Path, metavar="PAGE", help="only predict, see above")
    options = parser.parse_args()
    rows = []
    for row in _rows(options):
        tell(f"{row} {row.ratio:.2f}")
        rows.append(row)
    publish(options, "predicted_digits", page(rows, options.states))


if __name__ == "__main__":
    main()
