"""Code shape `kernels`: a plan's steps as loops over runs of joints, in axes that all links share.

A run is a sequence of joints each on the link of the one before. What needs no recursion (sines and
cosines, inertias and bias forces of bare links) is done for as many joints at once as registers
hold; what does is carried along a run in registers (templates/runtime/kernels/).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import groupby

from adagen.emit import mobility
from adagen.emit.layout import Layout
from adagen.emit.processes import describe_message
from adagen.emit.stages import stamped_groups
from adagen.emit.words import Words
from adagen.plan import Plan
from adagen.plan.abreast import (
    Limbs,
    Unit,
    ends_of,
    inward_order,
    outward_order,
    placed_links,
)
from adagen.plan.gather import why_not_gather
from adagen.plan.interpret import recovering
from adagen.plan.steps import (
    Accelerate,
    Articulate,
    FreeAcceleration,
    FreeBase,
    Kinematics,
    LoadRoot,
    Receive,
    Send,
    SolveRoot,
    StartEmpty,
    StartLink,
    Step,
)
from adagen.plan.types import Message, PlanJoint, PlanLink, Process

RUNTIME = (
    "status.hpp",
    "kernels/lanes.hpp",
    "kernels/algebra.hpp",
)

_TAKEN = (
    Kinematics
    | StartLink
    | StartEmpty
    | FreeBase
    | Articulate
    | SolveRoot
    | Accelerate
    | FreeAcceleration
    | Send
    | Receive
    | mobility.STEPS
)


def why_not(plan: Plan) -> str | None:
    """Return why a plan cannot be emitted in this shape; None where it can."""
    if plan.form != "segment":
        return f"it is for form segment, not {plan.form}"
    if (reason := why_not_gather(plan.joints, plan.wrenches)) is not None:
        return reason
    for process in plan.processes:
        for step in mobility.all_steps(process):
            if not isinstance(step, _TAKEN):
                return f"it has no {type(step).__name__} between processes"
    return mobility.why_not(plan)


@dataclass(frozen=True)
class Run:
    """Joints ``first`` .. ``last``, each on the link of the one before, passed in one direction."""

    first: int
    last: int
    reversed: bool = False


def values(words: Words) -> dict[str, object]:
    """Return what kernels.cpp.j2 is told."""
    plan = words.plan
    cuts = mobility.has_cuts(plan)
    again = recovering(plan).processes if any(p.recovery for p in plan.processes) else ()
    layout = Layout.of(plan, words.batch)
    writers = [_Writer(words, p, own, layout) for p, own in enumerate((*plan.processes, *again))]
    lines = [writer.all_lines() for writer in writers]
    return {
        "runtime": [*RUNTIME, *(mobility.RUNTIME if cuts else ())],
        "cuts": cuts,
        "cut_joints": [
            {"type": f"Joint_{words.joints[j]}", "id": f"j_{words.joints[j]}", "members": lines}
            for j, lines in mobility.members(words).items()
        ],
        "inertias": [_inertia(words, link) for link in plan.links[1:]],
        "roles": [writer.roles() for writer in writers],
        "steps": lines[: len(plan.processes)],
        "recovery": lines[len(plan.processes) :],
        "slots": layout.slots,
        "slot_count": layout.count,
        "limbs": [_limbs(words, layout, limbs) for limbs in layout.all_limbs],
    }


def pseudo_inertia(link: PlanLink) -> tuple[Fraction, ...]:
    """Return sum of m x x^T about the link's origin, upper triangle row by row, exactly.

    With the rotational inertia I about the centre of mass c: J = tr(I) / 2 - I + m c c^T.
    """
    mass, c = Fraction(link.mass), [Fraction(x) for x in link.com]
    half = sum((Fraction(link.tensor[k][k]) for k in range(3)), Fraction(0)) / 2
    return tuple(
        (half if i == k else 0) - Fraction(link.tensor[i][k]) + mass * c[i] * c[k]
        for i in range(3)
        for k in range(i, 3)
    )


def _inertia(words: Words, link: PlanLink) -> dict[str, str]:
    number, numbers = words.printer.number, words.printer.numbers
    mass = Fraction(link.mass)
    return {
        "mass": number(link.mass),
        "moments": numbers(float(mass * Fraction(x)) for x in link.com),
        "tensor": numbers(float(x) for x in pseudo_inertia(link)),
    }


def runs(joints: Sequence[PlanJoint], order: Iterable[int]) -> list[Run]:
    """Return the runs of joints passed outwards in an order."""
    found: list[Run] = []
    for j in order:
        if found and found[-1].last == j - 1 and joints[j].parent == j:
            found[-1] = Run(found[-1].first, j)
        else:
            found.append(Run(j, j))
    return found


def swept(joints: Sequence[PlanJoint], steps: Sequence[Articulate | Accelerate]) -> list[Run]:
    """Return the runs of a sweep, in its order; a sweep is either inwards or outwards."""
    found: list[Run] = []
    for step in steps:
        j = step.joint
        if found and found[-1].reversed == step.reversed:
            first, last = found[-1].first, found[-1].last
            if j == last + 1 and joints[j].parent == j:
                found[-1] = Run(first, j, step.reversed)
                continue
            if j == first - 1 and joints[first].parent == first:
                found[-1] = Run(j, last, step.reversed)
                continue
        found.append(Run(j, j, step.reversed))
    return found


def _ends(joints: Sequence[PlanJoint], run: Run) -> tuple[int, int]:
    """The near and the far link of a run."""
    parent, child = joints[run.first].parent, run.last + 1
    return (child, parent) if run.reversed else (parent, child)


def _limbs(words: Words, layout: Layout, limbs: Limbs) -> dict[str, object]:
    return {
        "count": limbs.count,
        "joints": len(limbs.rows),
        "slot": layout.slots[limbs.rows[0][0]],
        "rows": limbs.rows,
        "names": [words.span(*ends) for ends in zip(limbs.rows[0], limbs.rows[-1], strict=True)],
    }


def _parts(units: Iterable[Unit]) -> Iterable[Limbs | list[int]]:
    """Limbs, and the single joints between them."""
    for limbs, group in groupby(units, lambda unit: isinstance(unit, Limbs)):
        if limbs:
            yield from (unit for unit in group if isinstance(unit, Limbs))
        else:
            yield [unit for unit in group if isinstance(unit, int)]


def _spans(joints: Iterable[int]) -> list[tuple[int, int]]:
    """Joints as ranges first .. last."""
    found: list[tuple[int, int]] = []
    for j in sorted(joints):
        if found and found[-1][1] == j - 1:
            found[-1] = (found[-1][0], j)
        else:
            found.append((j, j))
    return found


class _Writer:
    """Turns the steps of one process into lines."""

    def __init__(self, words: Words, p: int, process: Process, layout: Layout) -> None:
        self.words, self.p, self.process, self.layout = words, p, process, layout
        self.joints = words.plan.joints
        self.limbs = layout.limbs[p] if p < len(layout.limbs) else ()  # none in recovery
        self.placed = placed_links(words.plan)
        self.started: set[int] = set()  # links whose body holds something
        self.gathers = set(self.placed)  # links at which paths meet inwards
        self.parts: set[int] = set()  # links at which paths part outwards

    def all_lines(self) -> list[str]:
        """Return the lines of the process."""
        stages = stamped_groups(self.process, self.lines)
        return [*self.checks(), *stages, *self.results()]

    def roles(self) -> list[dict[str, bool]]:
        """Return what the process does at each link, once its lines are written.

        See LinkRole in templates/kernels.cpp.j2.
        """
        own = {s.link for s in self.process.steps if isinstance(s, StartLink)} - self.placed
        return [
            {"gathers": k in self.gathers, "adds_own": k in own, "parts": k in self.parts}
            for k in range(len(self.words.plan.links))
        ]

    def checks(self) -> list[str]:
        """Refuse a state that is not finite."""
        reads, owns = self.process.reads, self.process.owns
        return [
            *self._finite("w.q", "q", reads, "kNotFinite"),
            *self._finite("w.v", "v", reads, "kNotFinite"),
            *self._finite("w.tau", "v", sorted((*owns, *self.process.shares)), "kNotFinite"),
        ]

    def results(self) -> list[str]:
        """Give the accelerations, if all went well."""
        owned = self._ranges("v", self.process.owns)
        return [
            *self._finite("w.answer.data()", "v", self.process.owns, "kOverflow"),
            *(f"give(w, {first}, {count});" for first, count in owned),
        ]

    def _finite(self, array: str, place: str, joints: Iterable[int], failure: str) -> list[str]:
        return [
            f"require_finite(w, {array}, {first}, {count}, &JointConstants::{place}, {failure});"
            for first, count in self._ranges(place, joints)
        ]

    def _ranges(self, name: str, joints: Iterable[int]) -> list[tuple[int, int]]:
        """Ranges (start, count) of q or v that joints have, those that touch made one."""
        found: list[tuple[int, int]] = []
        for j in joints:
            kind = self.words.kind(j)
            start, count = (
                (self.joints[j].q, kind.nq) if name == "q" else (self.joints[j].v, kind.nv)
            )
            if found and sum(found[-1]) == start:
                start, count = found[-1][0], found[-1][1] + count
                found.pop()
            found.append((start, count))
        return found

    def lines(self, steps: Sequence[Step]) -> list[str]:
        """Return the lines of the steps of a stage."""
        lines: list[str] = []
        for kind, group in groupby(steps, type):
            if issubclass(kind, mobility.STEPS):
                for step in group:
                    if isinstance(step, LoadRoot):
                        self.parts.add(step.link)
                    lines += mobility.lines_of(self.words, self.p, step)
            else:
                lines += getattr(self, f"_{kind.__name__}")(list(group))
        return lines

    def _Kinematics(self, steps: list[Kinematics]) -> list[str]:  # noqa: N802
        joints = [step.joint for step in steps]
        lines = self._angles(joints)
        turning = [j for j in joints if self.joints[j].kind not in ("spherical", "floating")]
        lines += [f"turn<{a}, {b}>(w);" for a, b in self._blocks(turning)]
        bases = [j for j in joints if self._is_base(j)]
        oriented = [j for j in joints if self.words.kind(j).quaternion is not None]
        lines += [f"orient<{j}>(w);" for j in oriented if j not in bases]
        lines += [f"free_base_frame<{j}>(w);" for j in bases]
        treated = {*self.process.owns, *self.process.shares}
        sweep = {j: ends_of(self.joints, j) for j in joints if j not in bases}
        for part in _parts(outward_order(sweep, self.limbs)):
            if isinstance(part, Limbs):
                lines.append(f"outward_abreast<{self._number(part)}>(w);")
                continue
            for verb, run in self._outward(part, treated):
                lines.append(f"{verb}<{run.first}, {run.last}>(w);{self._names(run)}")
        return lines

    def _number(self, limbs: Limbs) -> str:
        return f"kLimbs{self.layout.all_limbs.index(limbs)}"

    def _outward(self, joints: list[int], treated: set[int]) -> list[tuple[str, Run]]:
        """Runs outwards: of joints that are treated, and of those only passed on the way."""
        left = {self.joints[j].parent for j in joints if self.joints[j].parent != j}
        found: list[tuple[str, Run]] = []
        for run in runs(self.joints, joints):
            first = run.first
            for j in range(run.first, run.last + 1):
                ends = j == run.last or (j in treated) != (j + 1 in treated) or j + 1 in left
                if ends and j not in treated:
                    found.append(("pass_outward", Run(first, j)))
                elif j == run.last or (ends and j + 1 not in treated):
                    found.append(("outward", Run(first, j)))
                else:
                    continue
                first = j + 1
        return found

    def _is_base(self, j: int) -> bool:
        return self.joints[j].kind == "floating" and self.joints[j].parent == 0

    def _angles(self, joints: list[int]) -> list[str]:
        """Copy the angles of joints that turn, as many at once as lie side by side."""
        if not self.layout.plain:
            return [f"take_angles<{a}, {b}>(w);" for a, b in _spans(joints)]
        copies: list[tuple[int, int, int]] = []  # joint, place in q, count
        for j in joints:
            kind = self.joints[j].kind
            if kind not in ("revolute", "planar"):
                continue
            q = self.joints[j].q + (2 if kind == "planar" else 0)
            if copies and copies[-1][0] + copies[-1][2] == j and sum(copies[-1][1:]) == q:
                j, q, count = copies[-1][0], copies[-1][1], copies[-1][2] + 1
                copies.pop()
            else:
                count = 1
            copies.append((j, q, count))
        return [f"std::copy_n(w.q + {q}, {n}, w.angle.data() + {j});" for j, q, n in copies]

    def _blocks(self, joints: Iterable[int]) -> list[tuple[str, str]]:
        """Ranges of blocks that hold joints, as expressions."""
        ranges: list[list[int]] = []
        for j in sorted(self.layout.slots[j] for j in joints):
            if ranges and j - ranges[-1][1] < _WIDEST:
                ranges[-1][1] = j
            else:
                ranges.append([j, j])
        return [(f"block({a})", f"block({b}) + 1") for a, b in ranges]

    def _StartLink(self, steps: list[StartLink]) -> list[str]:  # noqa: N802
        links = [step.link for step in steps]
        lines = [f"set_up_links<{a}, {b}>(w);" for a, b in self._blocks(link - 1 for link in links)]
        for link in [link for link in links if link in self.placed]:
            starts = self._starts(link)
            lines.append(f"place<{link}, {starts}>(w);  // {self.words.quoted_link(link)} itself")
        return lines

    def _starts(self, link: int) -> str:
        """Whether what is to be left at a link is the first there, as a word."""
        first = link not in self.started
        self.started.add(link)
        return "true" if first else "false"

    def _StartEmpty(self, steps: list[StartEmpty]) -> list[str]:  # noqa: N802
        self.started -= {step.link for step in steps}  # what comes first takes its place
        self.gathers |= {step.link for step in steps}
        return []

    def _Send(self, steps: list[Send]) -> list[str]:  # noqa: N802
        lines = []
        for step in steps:
            message = self.words.plan.messages[step.message]
            lines += [
                f"{{  // to process {message.target}: {describe_message(self.words, message)}",
                f"  Real* to = channel.outgoing({step.message}, w.status);",
                *(f"  to = put(to, {item});" for item in self._items(message)),
                *(f"  to = put(to, w.bodies[{link}]);" for link in message.inertias),
                f"  channel.send({step.message}, w.status);",
                "}",
            ]
        return lines

    def _Receive(self, steps: list[Receive]) -> list[str]:  # noqa: N802
        lines = []
        for step in steps:
            message = self.words.plan.messages[step.message]
            lines += [
                f"{{  // from process {message.source}: {describe_message(self.words, message)}",
                f"  const Real* from = channel.receive({step.message}, w.status);",
                *(f"  from = get(from, {item});" for item in self._items(message)),
                *(f"  from = {self._taken(link)};" for link in message.inertias),
                "}",
            ]
        return lines

    def _items(self, message: Message) -> list[str]:
        return [
            *(self.words.block(block) for block in message.blocks),
            *(self.words.bias(bias) for bias in message.biases),
            *(self.words.force(force) for force in message.forces),
        ]

    def _taken(self, link: int) -> str:
        verb = "get" if self._starts(link) == "true" else "add"
        return f"{verb}(from, w.bodies[{link}])"

    def _FreeBase(self, steps: list[FreeBase]) -> list[str]:  # noqa: N802
        self.gathers |= {s.joint + 1 for s in steps}
        return [f"free_base<{s.joint}, {self._starts(s.joint + 1)}>(w);" for s in steps]

    def _Articulate(self, steps: list[Articulate]) -> list[str]:  # noqa: N802
        lines = []
        sweep = {s.joint: ends_of(self.joints, s.joint, s.reversed) for s in steps}
        by_joint = {step.joint: step for step in steps}
        for part in _parts(inward_order(sweep, self.limbs)):
            if isinstance(part, Limbs):
                lines += self._inward_abreast(part)
                continue
            for run in swept(self.joints, [by_joint[j] for j in part]):
                near = _ends(self.joints, run)[0]
                self.gathers.add(near)
                starts = self._starts(near)
                verb = "inward_reversed" if run.reversed else "inward"
                call = f"{verb}<{self.p}, {run.first}, {run.last}, {starts}>(w);"
                lines.append(call + self._names(run))
        return lines

    def _inward_abreast(self, limbs: Limbs) -> list[str]:
        """Sweep limbs inwards and leave what is found at the links that they hang on."""
        lines = [f"const auto X = inward_abreast<{self.p}, {self._number(limbs)}>(w);"]
        for lane, first in enumerate(limbs.rows[0]):
            near = self.joints[first].parent
            self.gathers.add(near)
            if near > 0:
                lines.append(f"leave<{self._starts(near)}>(w, {near}, lane(X, {lane}));")
        return ["{", *(f"  {line}" for line in lines), "}"]

    def _SolveRoot(self, steps: list[SolveRoot]) -> list[str]:  # noqa: N802
        return [f"solve_root<{self.p}, {step.link}>(w);" for step in steps]

    def _Accelerate(self, steps: list[Accelerate]) -> list[str]:  # noqa: N802
        lines = []
        sweep = {s.joint: ends_of(self.joints, s.joint, s.reversed) for s in steps}
        by_joint = {step.joint: step for step in steps}
        for part in _parts(outward_order(sweep, self.limbs)):
            if isinstance(part, Limbs):
                self.parts |= {self.joints[first].parent for first in part.rows[0]}
                lines.append(f"accelerate_abreast<{self.p}, {self._number(part)}>(w);")
                continue
            for run in swept(self.joints, [by_joint[j] for j in part]):
                self.parts.add(_ends(self.joints, run)[0])
                verb = "accelerate_reversed" if run.reversed else "accelerate"
                call = f"{verb}<{self.p}, {run.first}, {run.last}>(w);"
                lines.append(call + self._names(run))
        return lines

    def _FreeAcceleration(self, steps: list[FreeAcceleration]) -> list[str]:  # noqa: N802
        self.parts |= {step.joint + 1 for step in steps}
        return [f"free_acceleration<{step.joint}>(w);" for step in steps]

    def _names(self, run: Run) -> str:
        """Which joints a run is of, as a comment."""
        return f"  // {self.words.span(run.first, run.last)}"


_WIDEST = 16  # joints in the widest block: two apart by less may share one
