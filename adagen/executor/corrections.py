"""Corrections of a straight line's answer by its residuals (adagen/plan/steps: Correct).

The steps of a process are repeated in the same graph, with the residuals of links, joints and rows
(residuals.py) in place of forces, torques and biases. Everything else, above all the factors, is
the same expression and is not computed again.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.lanes import steps_in_order
from adagen.executor.repeatable import Repeatable
from adagen.executor.residuals import Answer, Energies, Residuals
from adagen.graph import Expression, matrix_times
from adagen.plan import steps as do
from adagen.plan.steps import Bias, Block, Passage, Step
from adagen.plan.types import Process

Array = NDArray[Any]
_KINEMATICS = (do.Kinematics, do.Traverse, do.Append, do.Arrive)


class Corrections:
    """Corrections of a process's answer.

    Args:
        machine: has carried out the process's own steps.
        steps: all steps of the process.
    """

    def __init__(self, machine: Repeatable, steps: Sequence[Step]) -> None:
        self.machine = machine
        count = next(
            (k for k, step in enumerate(steps) if isinstance(step, do.Correct)), len(steps)
        )
        self.steps = tuple(steps[:count])
        self.rounds: list[Repeatable] = []
        self._order: list[int] = []
        self._answer: Answer | None = None

    @property
    def current(self) -> Repeatable:
        """The correction that is being computed."""
        return self.rounds[-1]

    def step(self, step: do.Correct) -> None:
        """Repeat some steps for the residuals; the first ones begin a correction."""
        if step.first == 0:
            self._begin()
        for place in self._order:
            again = self.steps[place]
            if step.first <= place < step.last and not isinstance(again, _KINEMATICS):
                self._again(again)

    def in_order(self) -> list[Step]:
        """Return the steps that a correction repeats."""
        return [self.steps[place] for place in self._order]

    def _again(self, step: Step) -> None:
        """Repeat a step; a link's residual is computed where the link's acceleration is."""
        bounds = self.machine.bounds
        if isinstance(step, do.StartLink):
            with bounds.when_reached(step.link):
                self.current.step(step)
        else:
            bounds.begin(step)
            self.current.step(step)
        bounds.swept(step)  # of what is at hand

    def sizes(self) -> list[Expression]:
        """Return squared energy norms: of the answer, of all link accelerations, of corrections.

        What other processes start is theirs to count.
        """
        machine = self.machine
        energies = self.energies()
        first = _answer_of(machine)
        whole = energies.of(energies.without_fall(first.links), first.joints)
        found = [_answer_of(each) for each in self.rounds]
        parts = [energies.of(each.links, each.joints) for each in found]
        return [whole, energies.in_all(), *parts]

    def answer(self) -> Answer:
        """Return the answer of the process before corrections."""
        return _answer_of(self.machine)

    def energies(self) -> Energies:
        """The energies of the links that the process starts."""
        started = {s.link for s in self.steps if isinstance(s, do.StartLink | do.LinkBias)}
        links = [link for link in self.links() if link in started]
        return Energies(self.machine.motion, links)

    def finish(self) -> None:
        """Add all corrections to the answer, and report their sizes."""
        machine = self.machine
        machine.memory["energies", 0] = np.array(self.sizes(), dtype=object)
        for each in self.rounds:
            for j, qdd in each.results.items():
                machine.results[j] = machine.results[j] + qdd
            for place, force in each.forces.items():
                machine.forces[place] = machine.forces[place] + force

    def receive(self, known: Mapping[Any, Array], added: Set[Any]) -> None:
        """Reuse the contents of the answer's message that a repeated message does not contain.

        Args:
            known: what it brought.
            added: what of that is added to the process's own.
        """
        memory = self.current.memory
        for item, value in known.items():
            if isinstance(item, Block) or item[0] == "square":
                memory[item] = value
            elif item in added and item[0] == "IA":
                memory[item] = memory[item] + value

    def links(self) -> list[int]:
        """Links with residuals, rows of lanes by their first link."""
        biases = (name for name in self.machine.memory if isinstance(name, Bias))
        bare = [name.handle for name in biases if name.joint is None]
        return sorted({*_names(self.machine, "pA"), *bare})

    def _begin(self) -> None:
        """Begin the next correction, of the answer with those before it."""
        machine = self.machine
        if self._answer is None:
            self._order = steps_in_order(machine.plan, Process(self.steps, (), ()), machine.limbs)
            self._answer = _answer_of(machine)
        else:
            self._answer = self._answer.plus(_answer_of(self.current))
        again = machine.again(self.steps)
        for name, value in machine.memory.items():
            if isinstance(name, Passage) or (isinstance(name, tuple) and name[0] in ("X", "field")):
                again.memory[name] = value
        fronts = machine.closures.fronts
        ties = {(k, j): rows for k, front in fronts.items() for j, rows in front.ties.items()}
        again.left = Residuals(
            again.motion,
            {link: machine.motion.field_force(link) for link in self.links()},
            self._answer,
            {k: front.ends for k, front in fronts.items()},
            ties,
        )
        self.rounds.append(again)


def _names(machine: Repeatable, word: str) -> list[int]:
    """The numbers that a process's memory has under some name."""
    return [name[1] for name in machine.memory if isinstance(name, tuple) and name[0] == word]


def _answer_of(machine: Repeatable) -> Answer:
    """The answer of a process."""
    forces: dict[tuple[int, int], Expression] = {}
    for k, front in machine.closures.fronts.items():
        forces.update({(k, unknown): force for unknown, force in front.forces.items()})
    if machine.plan.form == "ada":
        torques = machine.memory["torques"]
        wrenches = {
            j: machine.memory["force", j][:, 0]
            + matrix_times(machine.memory["force", j][:, 1:], torques[:, None])[:, 0]
            for j in _names(machine, "force")
        }
        return Answer(_links_of(machine), dict(machine.results), forces, wrenches)
    links = {link: machine.memory["a", link][:, 0] for link in _names(machine, "a") if link > 0}
    return Answer(links, dict(machine.results), forces)


def _links_of(machine: Repeatable) -> dict[int, Array]:
    """Accelerations of links from those of joints, outwards from the ground."""
    found = {0: machine.zeros(6)}
    for j, joint in enumerate(machine.plan.joints):
        a = machine.memory["X", j].motion(found[joint.parent])
        drift = machine.motion.drift(j)
        a = a.copy() if drift is None else a + drift[:, 0]
        free = list(machine.kind(j).free)
        a[free] = a[free] + machine.results[j]
        found[j + 1] = a
    return {link: a for link, a in found.items() if link > 0}
