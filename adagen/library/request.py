"""The options of a compilation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from adagen.emit import check_batch, check_certified, check_form, check_reproducible
from adagen.emit.embedded import TARGETS, check_target
from adagen.emit.refine import RESIDUALS, checked_shape, checked_steps
from adagen.errors import UsageError
from adagen.schedule.caches import solved_in_lanes
from adagen.schedule.costs import StepCosts

MOST_PROCESSES = 1024


@dataclass(frozen=True)
class Request:
    """The options of a compilation, with the names of the command line.

    Attributes:
        procs: processes that share the robot, or the states of a batch.
        form: of the algorithm, "segment" or the paper's "ada".
        scalar: "double" or "float".
        channel: between processes, "auto", "window" or "message"; or "threads" of one program.
        shape: of the code, "auto", "unrolled", "kernels" or (form "ada") "joints".
        refine: steps of iterative refinement, 0 to 9; None: as many as the scalar needs.
        residual: what these find residuals in: the solver's "own" numbers, "wide" ones, or its own
            where loops have them ("auto").
        batch: whether many states are solved at once, one in each SIMD lane.
        profile: what operations cost: a profile's name, or its file.
        schedule: "auto", a name, or a file that ``adagen schedule --json`` printed.
        objective: what is searched for, "time", "accuracy" or "both".
        tie: among equally fast schedules, "work" or "lex".
        strategy: of the search, "exact", "astar" or "paper".
        split: how branches divide processes, "always", "free" or "any".
        parts: of long chains, one in each SIMD lane: where they pay ("auto"), or "none".
        naive: whether A* uses the paper's naive successors.
        expansions: how much the search may expand; None: what takes seconds.
        name: of the files; None: the robot description's.
        chunk: values that one function of shape unrolled computes; 0 for its default.
        compiler: that the source is meant for; "" for any.
        target: "host", or "embedded": a solver that needs no operating system, nor its heap.
        runtime: what can be set at run time, words with commas between them: "gravity",
            "mass:LINK", "center:LINK".
        tuned: whether shape, chunk and compiler were found by trying; processes do not gather then.
        single_file: whether the source holds the program around the solver, too.
        reproducible: whether answers are the same to the last bit on every number of processes, in
            whatever lanes, by every compiler and on every machine with numbers of IEEE 754.
        certify: whether a bound of its error comes with each answer.
        loop_forces: whether forces of loops and couplings are given behind the accelerations.
    """

    procs: int = 1
    form: Literal["segment", "ada"] = "segment"
    scalar: Literal["double", "float"] = "double"
    channel: Literal["auto", "window", "message", "threads"] = "auto"
    shape: str = "auto"
    refine: int | None = None
    residual: Literal["auto", "own", "wide"] = "auto"
    batch: bool = False
    profile: str = "default"
    schedule: str = "auto"
    objective: Literal["time", "accuracy", "both"] = "both"
    tie: Literal["work", "lex"] = "work"
    strategy: Literal["exact", "astar", "paper"] = "exact"
    split: Literal["always", "free", "any"] = "always"
    parts: Literal["auto", "none"] = "auto"
    naive: bool = False
    expansions: int | None = None
    name: str | None = None
    chunk: int = 0
    compiler: str = ""
    target: Literal["host", "embedded"] = "host"
    runtime: str = ""
    tuned: bool = False
    single_file: bool = False
    reproducible: bool = False
    certify: bool = False
    loop_forces: bool = False

    def __post_init__(self) -> None:
        """Refuse invalid options and combinations, for any robot.

        Raises:
            UsageError: a word is none of those known, or two exclude each other.
        """
        for field, known in _KNOWN.items():
            if getattr(self, field) not in known:
                raise UsageError(
                    f"{field} is one of {', '.join(known)}, not {getattr(self, field)!r}"
                )
        if not 1 <= self.procs <= MOST_PROCESSES:
            raise UsageError(f"procs is from 1 to {MOST_PROCESSES}, not {self.procs}")
        if self.refine is not None and not 0 <= self.refine <= 9:
            raise UsageError(f"refine is from 0 to 9, not {self.refine}")
        if self.naive and self.strategy == "exact":
            raise UsageError("naive is for strategy astar or paper")
        check_target(
            self.target,
            self.procs,
            self.refinement,
            batch=self.batch,
            single_file=self.single_file,
        )
        checked_shape(self.refinement, self.shape)
        if self.residual != "auto" and not self.refinement:
            raise UsageError("--residual needs --refine: add --refine 1, or leave out --residual")
        if self.batch:
            check_batch(self.shape, self.refinement, self.channel)
        if self.certify:
            check_certified(self.form, self.refinement)
            self._check_certified()
        if self.reproducible:
            check_reproducible(self.form, self.refinement, self.shape)
            self._check_hosted()
        check_form(self.form, self.shape)

    def _check_certified(self) -> None:
        """Refuse options that cannot be combined with --certify.

        Raises:
            UsageError: it is asked for, too.
        """
        for name, asked in (
            ("tune", self.tuned),
            ("target", self.target != "host"),
        ):
            if asked:
                raise UsageError(
                    f"certified solvers are not emitted with --{name}: leave out one of both"
                )

    def _check_hosted(self) -> None:
        """Refuse a target that cannot be combined with --reproducible."""
        if self.target != "host":
            raise UsageError(
                "reproducible solvers are not emitted with --target: leave out --reproducible or "
                "--target"
            )

    @property
    def refinement(self) -> int:
        """Steps of refinement that each evaluation takes."""
        return checked_steps(self.refine)

    @property
    def sharing(self) -> int:
        """Processes that share the robot: of a batch, each solves states by itself."""
        return 1 if self.batch else self.procs

    @property
    def may_gather(self) -> bool:
        """Whether processes may gather, which only shape kernels and straight lines support.

        Who asks for a strategy or a split asks for the paper's way to meet.
        """
        if self.strategy != "exact" or self.split != "always" or self.tuned:
            return False
        return self.shape in ("auto", "kernels") and not self.refinement

    @property
    def may_leave_idle(self) -> bool:
        """Whether processes may be left idle that are predicted to save less than the margin.

        Who names a schedule, asks for the paper's search or form, or for the most accurate schedule
        on as many processes, gets it.
        """
        usual = self.strategy == "exact" and self.split == "always" and self.form == "segment"
        return usual and self.schedule == "auto" and self.objective != "accuracy"

    def may_part(self, joints: int, costs: StepCosts) -> bool:
        """Whether a process may sweep a long chain in parts, one in each SIMD lane.

        Loops for one state do, whose answers are not the same on any number of processes. One
        process certifies them. A batch of chains of so many joints is solved state by state, if
        eight states, one in each lane, would not fit the cache, and they are not certified.
        """
        alone = self.reproducible or self.target != "host" or (self.certify and self.batch)
        alone |= self.batch and solved_in_lanes(joints, costs)
        return self.parts == "auto" and self.may_gather and self.form == "segment" and not alone

    @property
    def priced_shape(self) -> str:
        """The shape of a prediction: the requested one, or the one that other options need."""
        if self.reproducible:
            return "unrolled"
        if self.batch:
            return "kernels"
        if self.tuned:  # it was not known yet
            return "auto"
        if self.refinement and self.shape == "auto":
            return "joints" if self.form == "ada" else "kernels"
        return self.shape


_KNOWN = {
    "form": ("segment", "ada"),
    "scalar": ("double", "float"),
    "residual": RESIDUALS,
    "channel": ("auto", "window", "message", "threads"),
    "target": TARGETS,
    "shape": ("auto", "unrolled", "kernels", "joints"),
    "objective": ("time", "accuracy", "both"),
    "tie": ("work", "lex"),
    "strategy": ("exact", "astar", "paper"),
    "split": ("always", "free", "any"),
    "parts": ("auto", "none"),
}
