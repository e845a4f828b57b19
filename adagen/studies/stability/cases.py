"""The failing cases: what a weak method does there, and what the shipped one has to show."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from adagen.studies.stability import linkages, robots
from adagen.studies.stability.closed_cases import (
    Array,
    ClosedTrial,
    State,
    Tally,
    dense,
    dense_independent,
    null_space,
    shipped,
)
from adagen.studies.stability.loops import coupled_loops, four_bar
from adagen.studies.stability.methods import METHODS, Trial
from adagen.studies.stability.motion import damped_tip, tumbling_body
from adagen.studies.stability.pinocchio_closed import Solve, installed, solvers


@dataclass(frozen=True)
class Finding:
    """One figure.

    Attributes:
        method: what was done.
        weak: whether it is expected to fail or to lose digits.
        figure: an error, a step or an order; infinity for a failure.
        result: the figure, or the reason of a failure, for people.
        must: what it has to be, for people.
        good: whether it is.
    """

    method: str
    weak: bool
    figure: float
    result: str
    must: str
    good: bool


@dataclass(frozen=True)
class Outcome:
    """A case and what was found; ``good`` where everything is as it must be."""

    number: int
    title: str
    findings: tuple[Finding, ...]

    @property
    def good(self) -> bool:
        """Whether the weak methods fail as expected and the shipped ones do not."""
        return all(finding.good for finding in self.findings)


@dataclass(frozen=True)
class Case:
    """A case of the suite.

    Attributes:
        number: as in docs/records/stability.md.
        title: in a few words.
        run: finds out; the argument shortens what takes long.
    """

    number: int
    title: str
    run: Callable[[bool], tuple[Finding, ...]]


def run_case(case: Case, quick: bool = False) -> Outcome:
    """Return what is found of a case.

    Args:
        case: one of ``CASES``.
        quick: with shorter chains where a case takes seconds.
    """
    return Outcome(case.number, case.title, case.run(quick))


def _below(trial: Trial, method: str, most: float) -> Finding:
    error, reason = trial.outcome(METHODS[method])
    return Finding(method, False, error, reason or f"{error:.1e}", f"< {most:g}", error < most)


def _above(trial: Trial, method: str, least: float) -> Finding:
    error, reason = trial.outcome(METHODS[method])
    return Finding(method, True, error, reason or f"{error:.1e}", f"> {least:g}", error > least)


def _refused(method: str, outcome: tuple[float, str], names: tuple[str, ...]) -> Finding:
    """A refusal that names a joint or a link."""
    error, reason = outcome
    good = error == float("inf") and any(f'"{name}"' in reason for name in names)
    must = f"error naming {' or '.join(names)}"
    return Finding(method, False, error, reason or f"{error:.1e}", must, good)


def _long(quick: bool) -> tuple[Finding, ...]:
    trial = Trial(robots.rods(200 if quick else 1000))
    cut = () if quick else (_below(trial, "form segment, cut in four", 1e-11),)
    return (
        _above(trial, "composite bodies", 1e-13 if quick else 1e-11),
        _above(trial, "composite bodies, float", 1e-5 if quick else 1.0),
        _below(trial, "form ada", 1e-11),
        _below(trial, "form ada, refined once", 1e-13),
        _below(trial, "form segment", 1e-11),
        *cut,
    )


def _spherical(_: bool) -> tuple[Finding, ...]:
    trial = Trial(robots.spherical_rods(60))
    return (
        _above(trial, "articulated bodies, textbook", 1.0),
        _below(trial, "form segment", 1e-12),
        _below(trial, "form segment, cut in four", 1e-12),
        _below(trial, "form ada", 1e-12),
    )


def _light(_: bool) -> tuple[Finding, ...]:
    trial = Trial(robots.with_mass(30, 15, 1e-8))
    return (
        _above(trial, "form ada", 1e-9),
        _below(trial, "form ada, refined twice", 1e-13),
        _below(trial, "form segment", 1e-13),
        _below(trial, "form segment, cut in four", 1e-13),
    )


def _slender(_: bool) -> tuple[Finding, ...]:
    trial = Trial(robots.rods(30, radius=5e-4))
    return (
        _above(trial, "form ada", 1e-11),
        _below(trial, "form ada, refined once", 1e-13),
        _below(trial, "form segment", 1e-13),
        _below(trial, "form segment, cut in four", 1e-13),
    )


def _heavy(_: bool) -> tuple[Finding, ...]:
    trial = Trial(robots.with_mass(30, 30, 1e8))
    return (
        _above(trial, "composite bodies", 1e-12),
        _below(trial, "form ada", 1e-11),
        _below(trial, "form ada, refined once", 1e-13),
        _below(trial, "form segment", 1e-11),
        _below(trial, "form segment, refined once", 1e-13),
        _below(trial, "form segment, cut in four", 1e-10),
    )


def _massless(_: bool) -> tuple[Finding, ...]:
    trial = Trial(robots.three_axis(4))
    return (
        _above(trial, "form ada, joints not fused", 1.0),
        _below(trial, "form ada", 1e-11),
        _below(trial, "form segment", 1e-11),
        _below(trial, "form segment, refined once", 1e-11),
        _below(trial, "form segment, cut in four", 1e-11),
    )


def _distant(_: bool) -> tuple[Finding, ...]:
    trial = Trial(robots.far_away(30, 1e3))
    return (
        _above(trial, "articulated bodies, world frame", 1e-10),
        _below(trial, "form ada", 1e-11),
        _below(trial, "form segment", 1e-11),
        _below(trial, "form segment, cut in four", 1e-11),
    )


def _measured(
    rows: tuple[tuple[str, bool, float, str, bool], ...],
) -> tuple[Finding, ...]:
    return tuple(
        Finding(name, weak, figure, f"{figure:.3g}", must, good)
        for name, weak, figure, must, good in rows
    )


def _loops(_: bool) -> tuple[Finding, ...]:
    return _measured(four_bar() + coupled_loops())


def _leaf(_: bool) -> tuple[Finding, ...]:
    trial = Trial(robots.massless_leaf(5))
    return (
        _above(trial, "articulated bodies, textbook", 1.0),
        *(
            _refused(name, trial.outcome(METHODS[name]), ("link5", "j5"))
            for name in ("form ada", "form segment", "form segment, cut in four")
        ),
    )


def _coil(_: bool) -> tuple[Finding, ...]:
    trial = Trial(robots.coil(100))
    return (
        _above(trial, "composite bodies, float", 1e-4),
        _above(trial, "form ada", 1e-11),
        _below(trial, "form ada, refined once", 1e-13),
        _below(trial, "form segment", 1e-12),
        _below(trial, "form segment, refined once", 1e-13),
        _below(trial, "form segment, cut in four", 1e-11),
    )


def _dill(_: bool) -> tuple[Finding, ...]:
    trial = Trial(robots.dill(5))
    return (
        _above(trial, "articulated bodies, world frame", 1e-7),
        _above(trial, "form ada", 1e-10),
        _below(trial, "form ada, refined twice", 1e-13),
        _below(trial, "form segment", 1e-13),
        _below(trial, "form segment, cut in four", 1e-12),
    )


def _closed(
    trial: ClosedTrial, most: float, *, refused: int = 0, lost: float = np.inf
) -> tuple[Finding, ...]:
    """Solvers of a mechanism side by side.

    Args:
        trial: the mechanism and its states.
        most: error that the shipped one may have.
        refused: states that it may refuse.
        lost: error that the KKT system of all rows must exceed; infinity where it must fail.
    """
    own, plain = trial.tally(shipped), trial.tally(dense)
    weak = _figure(plain) > lost or (np.isinf(lost) and plain.refused == plain.states)
    must = "fails" if np.isinf(lost) else f"> {lost:g}"
    found = [
        Finding("KKT by LU, all rows", True, _figure(plain), plain.result, must, weak),
        _beside("KKT by LU, independent rows", trial.tally(dense_independent)),
        _beside("orthonormal null space", trial.tally(null_space)),
    ]
    if installed():
        for name, solve in solvers(trial.model, trial.states.q[0]).items():
            found.append(_beside(name, trial.tally(partial(_asked, solve))))
    good = own.error < most and own.refused <= refused
    limit = f"< {most:g}" + (f", at most {refused} refused" if refused else "")
    return (*found, Finding("form segment", False, _figure(own), own.result, limit, good))


def _asked(solve: Solve, _: ClosedTrial, state: State) -> Array:
    return solve(*state)


def _beside(method: str, tally: Tally) -> Finding:
    """A figure to be compared with, whatever it is."""
    return Finding(method, False, _figure(tally), tally.result, "", True)


def _figure(tally: Tally) -> float:
    return float("inf") if tally.refused == tally.states else tally.error


def _change_point(_: bool) -> tuple[Finding, ...]:
    model = linkages.bars(1.0, 2.0, 1.0, across=2.0)
    return _closed(ClosedTrial(model, linkages.passing(model, 2)), 1e-8, refused=2)


def _flat(_: bool) -> tuple[Finding, ...]:
    return tuple(
        replace(finding, method=f"{shorter:g}: {finding.method}")
        for shorter in (1e-7, 1e-11)
        for finding in _closed(ClosedTrial(*linkages.slack(shorter)), 1e-9)
    )


def _redundant(_: bool) -> tuple[Finding, ...]:
    model = linkages.parallelogram(3)
    return _closed(ClosedTrial(model, linkages.turned(model, 3, (0.3, 1.0, 2.0, 4.0))), 1e-12)


def _light_coupler(_: bool) -> tuple[Finding, ...]:
    model = linkages.bars(0.2, 0.5, 0.4, across=0.45, massless=2)
    return _closed(ClosedTrial(model, linkages.anywhere(model, 6)), 1e-12)


def _ring(quick: bool) -> tuple[Finding, ...]:
    model = linkages.ring(20 if quick else 64)
    lost = 1e-12 if quick else 1e-11
    return _closed(ClosedTrial(model, linkages.anywhere(model, 1)), 1e-12, lost=lost)


CASES = (
    Case(1, "1000 links", _long),
    Case(2, "60 spherical joints", _spherical),
    Case(3, "one light link of 1e-8 kg among 30", _light),
    Case(4, "slender rods, r = 5e-4 m", _slender),
    Case(5, "a tip of 1e8 kg on 30 links", _heavy),
    Case(6, "three axes through massless links, four times", _massless),
    Case(7, "the base 1 km away", _distant),
    Case(8, "a damped tip of 1e-4 kg", lambda _: _measured(damped_tip())),
    Case(9, "a tumbling body, 20 s", lambda _: _measured(tumbling_body())),
    Case(10, "closed loops with redundant rows", _loops),
    Case(11, "a massless leaf", _leaf),
    Case(12, "a coil of 100 links", _coil),
    Case(13, "a dill of level 5: sizes over five decades", _dill),
    Case(14, "a four-bar at speed through its change point", _change_point),
    Case(15, "a four-bar nearly flat: slack of 1e-7 and 1e-11", _flat),
    Case(16, "three equal rockers under a beam", _redundant),
    Case(17, "a four-bar with a massless coupler", _light_coupler),
    Case(18, "a ring of 64 ball joints", _ring),
)
