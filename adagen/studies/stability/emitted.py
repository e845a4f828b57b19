"""What emitted solvers keep of their digits: every shape, meeting, number of threads and scalar.

Each is emitted, built and run on states of a robot, and compared with accelerations that are
certified in ball arithmetic; beside it the executor, which carries out the same plan, and the
digits that are predicted. Processes are threads of one program: they compute what processes do.
"""

from __future__ import annotations

import hashlib
import json
import math
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.build import Toolchain
from adagen.build.cache import kept_text
from adagen.emit.runtime import joined
from adagen.emit.shapes import BASELINES, MOST_FREEDOMS
from adagen.errors import AdagenError, EnvironmentFault
from adagen.executor import interpret
from adagen.graph import DOUBLE, FLOAT
from adagen.model import Model
from adagen.plan import Plan, plan_to_json
from adagen.plan.digits import EPSILON
from adagen.reference import energy_norm_error, joint_space_inertia
from adagen.search.objective import FEW, predicted_digits
from adagen.states import States, random_states
from adagen.studies.random_states import drawn_states, hard_states
from adagen.studies.stability import linkages, robots
from adagen.studies.stability.audit import WRONG, Way, planned, solved, source_of, truths
from adagen.version import __version__

Array = NDArray[np.float64]
PROCESSES = (1, 2, 4)
MEETINGS = ("searched", "joined", "exchanged", "gathered")
SCALARS = ("double", "float")
SHAPES = ("kernels", "unrolled", "joints", *BASELINES)


@dataclass(frozen=True)
class Subject:
    """A robot, and the states in which it is solved."""

    name: str
    model: Model
    states: States

    def truths(self, scalar: str, toolchain: Toolchain) -> list[Array | None]:
        """Return the true accelerations of its states, None where inertias are singular."""
        given = self.given(scalar)
        texts = [__version__, _of_model(self.model), *map(_of_array, given.parts)]

        def found() -> str:
            every = truths(self.model, given)
            return json.dumps([None if one is None else one.tolist() for one in every])

        kept = json.loads(kept_text(texts, "truths.json", toolchain, found))
        return [None if one is None else np.array(one) for one in kept]

    def given(self, scalar: str) -> States:
        """Return its states as they are given in a scalar: what is true is true of these."""
        return self.states.read_in(scalar)


@dataclass(frozen=True)
class Cell:
    """The result of a robot in one variant.

    Attributes:
        robot: its name.
        way: how it was solved.
        states: how many were given.
        refused: how many of them were refused.
        error: the largest of the answers, in the energy norm; infinite for one that is wrong
            where nothing is known; None where none was given.
        state: that has it.
        joint: of that state, the joint that is farthest off.
        executor: largest error of the executor of the plan likewise; None where it has none.
        predicted: the error that is predicted in hard states; None where nothing is.
        why: it is not solved so at all.
        same: the way whose source it has, if it is another's.
        silent: whether some answer is wrong that neither was refused nor warned of.
    """

    robot: str
    way: Way
    states: int = 0
    refused: int = 0
    error: float | None = None
    state: int = 0
    joint: str = ""
    executor: float | None = None
    predicted: float | None = None
    why: str = ""
    same: str = ""
    silent: bool = False

    @property
    def verdict(self) -> str:
        """In a few words."""
        if self.why:
            return "not solved so"
        if self.error is None:
            return "refused"
        if not self.error <= WRONG[self.way.scalar]:
            return "wrong, silently" if self.silent else "wrong, warned of"
        return "refused in part" if self.refused else "right"

    def listed(self) -> dict[str, Any]:
        """Return it as JSON has it."""
        found = asdict(self)
        for key in ("error", "executor", "predicted"):
            value = found[key]
            found[key] = "infinite" if value is not None and not math.isfinite(value) else value
        return {**found, "words": self.way.words, "verdict": self.verdict}


def ways(
    shapes: Sequence[str] = SHAPES,
    processes: Sequence[int] = PROCESSES,
    scalars: Sequence[str] = SCALARS,
    meetings: Sequence[str] = MEETINGS,
) -> list[Way]:
    """Return the variants in which a robot is solved, the most common first."""
    found = []
    for scalar in scalars:
        for count in processes:
            for shape in shapes:
                form = "ada" if shape == "joints" else "segment"
                if count == 1:
                    found.append(Way(shape, 1, scalar, "joined", form))
                elif shape not in BASELINES:
                    met = meetings if form == "segment" else ("joined",)
                    found += [Way(shape, count, scalar, meeting, form) for meeting in met]
    plain = ("kernels", "unrolled")
    return sorted(found, key=lambda way: (way.shape not in plain, way.scalar, way.threads))


def subject(name: str, model: Model, count: int, seed: int = 1) -> Subject:
    """Return a robot with random states, half of them near quarter turns, fast and strained."""
    soft = drawn_states(model, count - count // 2, seed)
    hard = hard_states(model, count // 2, seed) if count > 1 else None
    parts = soft.parts if hard is None else map(np.vstack, zip(soft.parts, hard.parts))  # noqa: B905
    return Subject(name, model, States(*parts))


def suite(count: int) -> list[Subject]:
    """Return the suite's robots, shortened, each in the suite's state and random ones."""
    made = [
        ("7 rods", robots.rods(7)),
        ("30 rods", robots.rods(30)),
        ("10 ball joints", robots.spherical_rods(10)),
        ("a link of 1e-8 kg among 10", robots.with_mass(10, 5, 1e-8)),
        ("10 rods of radius 0.5 mm", robots.rods(10, radius=5e-4)),
        ("a tip of 1e8 kg on 10", robots.with_mass(10, 10, 1e8)),
        ("10 rods, masses graded 1e8", robots.graded(10, 1e8)),
        ("three axes, massless, 4 times", robots.three_axis(4)),
        ("10 rods, base 1 km away", robots.far_away(10, 1e3)),
        ("a coil of 20", robots.coil(20)),
        ("a dill of level 3", robots.dill(3)),
    ]
    more = max(1, count - 1)
    found = [
        Subject(name, model, robots.states_with(model, random_states(model, more, seed=1)))
        for name, model in made
    ]
    looped = [
        ("a four-bar, coupler massless", linkages.bars(0.2, 0.5, 0.4, across=0.45, massless=2)),
        ("three equal rockers, a beam", linkages.parallelogram(3)),
        ("a ring of 8 ball joints", linkages.ring(8)),
    ]
    return found + [subject(name, model, count) for name, model in looped]


@dataclass
class Study:
    """Robots solved in many ways, within a time.

    Attributes:
        subjects: the robots.
        ways: how they are solved.
        toolchain: what is compiled with.
        seconds: after which nothing new is begun.
        cells: what has been found.
    """

    subjects: Sequence[Subject]
    ways: Sequence[Way]
    toolchain: Toolchain
    seconds: float
    cells: list[Cell] = field(default_factory=list)

    @property
    def left(self) -> int:
        """How many robots and ways have not been looked at."""
        return len(self.subjects) * len(self.ways) - len(self.cells)

    def run(self, tell: Callable[[str], None]) -> None:
        """Solve them all, or as many as there is time for; tell how far that is.

        Raises:
            EnvironmentFault: there is no compiler.
        """
        begun = time.monotonic()
        todo = ((one, way) for way in self.ways for one in self.subjects)
        sources: dict[tuple[str, str], Way] = {}
        for one, way in todo:
            spent = time.monotonic() - begun
            if spent > self.seconds:
                return
            if self.cells:
                rest = min(spent / len(self.cells) * self.left, self.seconds - spent)
                about = f"about {rest / 60:.0f} min" if rest >= 90 else f"about {rest:.0f} s"
                tell(f"{one.name}, {way.words} ({self.left} left, {about})")
            else:
                tell(f"{one.name}, {way.words}")
            self.cells.append(self._cell(one, way, sources))

    def _cell(self, one: Subject, way: Way, sources: dict[tuple[str, str], Way]) -> Cell:
        cell = Cell(one.name, way, one.states.count)
        if way.shape == "unrolled" and one.model.nv > MOST_FREEDOMS:
            return replace(cell, why="its straight line would take minutes to compile")
        plan = planned(one.model, way)
        if plan is None:
            return replace(cell, why=f"not all of {way.threads} threads would have work")
        try:
            source = source_of(plan, way)
        except AdagenError as error:
            return replace(cell, why=error.reason)
        key = (one.name, hashlib.sha256(source.encode()).hexdigest())
        if key in sources:
            return replace(cell, same=sources[key].words, **_figures(self.cells, one, sources[key]))
        sources[key] = way
        return self._solved(one, cell, plan, source)

    def _solved(self, one: Subject, cell: Cell, plan: Plan, source: str) -> Cell:
        """The cell of what was built and run, now or at an earlier time."""
        given = one.given(plan.scalar)
        texts = [__version__, joined(source), *map(_of_array, given.parts)]

        def answers() -> str:
            rows = solved(source, plan, given, self.toolchain)
            return json.dumps([None if row is None else row.tolist() for row in rows])

        try:
            rows = json.loads(kept_text(texts, "answers.json", self.toolchain, answers))
        except EnvironmentFault as fault:
            return replace(cell, why=fault.reason)
        judge = _Judge(one, one.truths(plan.scalar, self.toolchain), given)
        every = [None if row is None else np.array(row, dtype=np.float64) for row in rows]
        error, state = judge.largest(every)
        predicted = self._predicted(one, plan, cell.way)
        few = predicted is not None and predicted > FEW[plan.scalar]
        return replace(
            cell,
            refused=sum(row is None for row in every),
            error=error,
            state=state,
            joint="" if error is None else judge.worst(every, state),
            executor=None if cell.way.shape in BASELINES else judge.executor(plan),
            predicted=predicted,
            silent=error is not None and not error <= WRONG[plan.scalar] and not few,
        )

    @staticmethod
    def _predicted(one: Subject, plan: Plan, way: Way) -> float | None:
        if way.shape in BASELINES:
            return None
        try:
            return float(predicted_digits("both", one.model, plan, way.shape).anywhere)
        except FloatingPointError:
            return math.inf


class _Judge:
    """How far answers are from the truth."""

    def __init__(self, one: Subject, truth: Sequence[Array | None], given: States) -> None:
        self.one, self.truth, self.given = one, truth, given

    @cached_property
    def _inertias(self) -> list[Array]:
        return [joint_space_inertia(self.one.model, q) for q in self.given.q]

    def largest(self, rows: Sequence[Array | None]) -> tuple[float | None, int]:
        """The largest error of the answers that were given, and its state."""
        errors = [(self._error(row, s), s) for s, row in enumerate(rows) if row is not None]
        return max(errors) if errors else (None, 0)

    def _error(self, row: Array, s: int) -> float:
        truth = self.truth[s]
        if truth is None or not np.isfinite(row).all():
            return math.inf  # where inertias are singular every answer is wrong
        if not truth.any():
            return float(np.abs(row).max())
        error = float(energy_norm_error(self._inertias[s], row - truth, truth))
        if math.isfinite(error):
            return error
        return float(np.abs(row - truth).max() / np.abs(truth).max())

    def worst(self, rows: Sequence[Array | None], s: int) -> str:
        """The joint whose acceleration is farthest off in a state."""
        row, truth, model = rows[s], self.truth[s], self.one.model
        if row is None or truth is None:
            return ""
        off = np.nan_to_num(np.abs(row - truth), nan=np.inf)
        entry = int(np.argmax(off))
        place = max(j for j, v in enumerate(model.v_start) if v <= entry)
        return model.joints[place].name

    def executor(self, plan: Plan) -> float | None:
        """The largest error of the executor of a plan, where it does not refuse."""
        algebra = DOUBLE if plan.scalar == "double" else FLOAT
        rows: list[Array | None] = []
        for state in self.given.each:
            try:
                with np.errstate(all="ignore"):
                    found = interpret(plan, *state, algebra)
                rows.append(np.asarray(found, dtype=np.float64))
            except FloatingPointError:
                rows.append(None)
        return self.largest(rows)[0]


def digits(error: float | None, scalar: str) -> float:
    """Return the decimal digits that an error leaves, 0 to those of the scalar."""
    if error is None or not error < 1.0:
        return 0.0
    return float(-np.log10(max(error, EPSILON[scalar])))


def _figures(cells: Sequence[Cell], one: Subject, way: Way) -> dict[str, Any]:
    """The results of a robot in one variant."""
    cell = next(each for each in cells if each.robot == one.name and each.way == way)
    names = ("refused", "error", "state", "joint", "executor", "predicted", "silent", "why")
    return {name: getattr(cell, name) for name in names}


def _of_array(x: Array) -> str:
    return hashlib.sha256(np.ascontiguousarray(x, np.float64).tobytes()).hexdigest()


def _of_model(model: Model) -> str:
    plan = planned(model, Way("kernels"))
    return repr(model.joints) if plan is None else plan_to_json(plan)


def tables(cells: Sequence[Cell]) -> Iterator[list[str]]:
    """Yield rows for people: way, digits of the emitted code, executor, predicted, and verdict."""
    for cell in cells:
        scalar = cell.way.scalar

        def cell_text(error: float | None, scalar: str = scalar) -> str:
            return "-" if error is None else f"{digits(error, scalar):.1f}"

        text = cell.why or cell.verdict
        if cell.same:
            text = f"as {cell.same}"
        elif cell.refused and cell.error is not None:
            text += f" ({cell.refused} of {cell.states})"
        elif cell.verdict.startswith("wrong"):
            text += f": state {cell.state + 1}, {cell.joint}"
        yield [
            cell.robot,
            cell.way.words,
            cell_text(cell.error),
            cell_text(cell.executor),
            cell_text(cell.predicted),
            text,
        ]
