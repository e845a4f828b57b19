"""The lines of a process in shape kernels: calls of what templates/runtime/kernels defines."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import groupby

from adagen.emit import guards, mobility
from adagen.emit.effects import push_calls
from adagen.emit.layout import Layout
from adagen.emit.processes import describe_message
from adagen.emit.runs import (
    Run,
    ends_of_run,
    links_of_run,
    outward_units,
    pays_columns,
    spans,
    sweep_of,
    units_of_sweep,
)
from adagen.emit.segments import split
from adagen.emit.stages import stamped_groups
from adagen.emit.words import Words
from adagen.plan.abreast import Limbs, placed_links
from adagen.plan.edges import is_base
from adagen.plan.order import inward_order, outward_order
from adagen.plan.steps import (
    Accelerate,
    Articulate,
    Deliver,
    FreeAcceleration,
    FreeBase,
    Kinematics,
    LoadRoot,
    Propagate,
    Receive,
    Send,
    SolveRoot,
    StartEmpty,
    StartLink,
    Step,
)
from adagen.plan.types import Message, Process


class KernelLines:
    """Turns the steps of one process into lines."""

    def __init__(self, words: Words, p: int, process: Process, layout: Layout) -> None:
        self.words, self.p, self.process, self.layout = words, p, process, layout
        self.joints = words.plan.joints
        self.limbs = layout.limbs[p] if p < len(layout.limbs) else ()  # none in recovery
        self.placed = placed_links(words.plan)
        self.started: set[int] = set()  # links whose body holds something
        self.gathers = set(self.placed)  # links at which paths meet inwards
        self.parts: set[int] = set()  # links at which paths part outwards
        self.oriented: set[int] = set()  # joints whose quaternions are taken
        self.columns: set[int] = set()  # links that are added to columns
        self.bare: set[int] = set()  # links that are set up
        self.told: set[int] = set()  # those of them that are told by columns, too

    def all_lines(self) -> list[str]:
        """Return the lines of the process."""
        stages = stamped_groups(self.process, self.lines)
        return [
            *guards.checks(self.words, self.process),
            *stages,
            *guards.results(self.words, self.process),
        ]

    def roles(self) -> list[dict[str, bool]]:
        """Return what the process does at each link, once its lines are written.

        See LinkRole in templates/kernels.cpp.j2.
        """
        own = self._own_links()
        return [
            {
                "gathers": k in self.gathers,
                "adds_own": k in own,
                "parts": k in self.parts,
                "oriented": k - 1 in self.oriented,
            }
            for k in range(len(self.words.plan.links))
        ]

    def _own_links(self) -> set[int]:
        """Links that the process adds as its sweep passes them."""
        return {s.link for s in self.process.steps if isinstance(s, StartLink)} - self.placed

    def lines(self, steps: Sequence[Step]) -> list[str]:
        """Return the lines of the steps of a stage."""
        lines: list[str] = []
        for kind, group in groupby(steps, type):
            together = getattr(self, f"_{kind.__name__}", None)
            if together is not None:
                lines += together(list(group))
                continue
            for step in group:
                if isinstance(step, LoadRoot):
                    self.parts.add(step.link)
                lines += mobility.lines_of(self.words, self.p, step)
        return lines

    def _Kinematics(self, steps: list[Kinematics]) -> list[str]:  # noqa: N802
        joints = [step.joint for step in steps]
        lines = self._angles(joints)
        turning = [j for j in joints if self.joints[j].kind not in ("spherical", "floating")]
        lines += [f"turn<{a}, {b}>(w);" for a, b in self._blocks(turning)]
        bases = [j for j in joints if is_base(self.joints[j])]
        oriented = [
            j for j in joints if self.words.kind(j).quaternion is not None and j not in bases
        ]
        self.oriented.update(oriented)
        lines += [f"orient<{self.p}, {a}, {b}>(w);" for a, b in self._blocks(oriented)]
        lines += [f"free_base_frame<{j}>(w);" for j in bases]
        for unit in outward_units(self.joints, joints, self.limbs, self.process.treated):
            if isinstance(unit, Limbs):
                lines.append(f"outward_abreast<{self._number(unit)}>(w);")
                continue
            verb = "outward" if unit.treated else "pass_outward"
            for run, in_segments in split(unit.run, self.layout.segments):
                call = f"{verb}{'_in_segments' * in_segments}<{run.first}, {run.last}>(w);"
                lines.append(call + self._names(run))
        return lines

    def _number(self, limbs: Limbs) -> str:
        return f"kLimbs{self.layout.all_limbs.index(limbs)}"

    def _angles(self, joints: list[int]) -> list[str]:
        """Copy the angles of joints that turn, as many at once as lie side by side."""
        if not self.layout.plain:
            return [
                f"take_angles{'_in_segments' * in_segments}<{run.first}, {run.last}>(w);"
                for span in spans(joints)
                for run, in_segments in split(Run(*span), self.layout.segments)
            ]
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

    def _ranges(self, joints: Iterable[int]) -> list[tuple[int, int]]:
        """First and last slots of ranges that hold joints and in which no block is empty."""
        ranges: list[tuple[int, int]] = []
        for slot in sorted(self.layout.slots[j] for j in joints):
            if ranges and slot - ranges[-1][1] < _WIDEST:
                ranges[-1] = (ranges[-1][0], slot)
            else:
                ranges.append((slot, slot))
        return ranges

    def _blocks(self, joints: Iterable[int]) -> list[tuple[str, str]]:
        """Ranges of blocks that hold joints, as expressions."""
        return _expressions(self._ranges(joints))

    def _StartLink(self, steps: list[StartLink]) -> list[str]:  # noqa: N802
        links = [step.link for step in steps]
        self.bare.update(links)
        lines = [f"set_up_links<{a}, {b}>(w);" for a, b in self._blocks(link - 1 for link in links)]
        lines += push_calls(self.words, links)
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
        lines: list[str] = []
        columns: set[int] = set()
        for run in units_of_sweep(self.joints, steps, self.limbs, inward_order):
            if isinstance(run, Limbs):
                lines += self._inward_abreast(run)
                continue
            near = ends_of_run(self.joints, run)[0]
            if near == 0 and self.joints[run.first].prescribed:
                continue  # the ground moves as it does, and so does what it carries
            self.gathers.add(near)
            verb = "inward"
            if not self.words.batch and pays_columns(self.joints, run):
                verb = "inward_in_columns"
                columns |= set(links_of_run(self.joints, run)) - {near}
            call = sweep_of(self.joints, run, verb, self.p, self._starts(near))
            lines.append(call + self._names(run))
        self.columns |= columns
        return [*self._tell_by_columns(columns & self._own_links()), *lines]

    def _tell_by_columns(self, links: set[int]) -> list[str]:
        """Tell those links by columns that are not yet, and with them what lies among them."""
        ranges = self._ranges(link - 1 for link in links - self.told)
        for a, b in ranges:
            self.told |= {link for link in self.bare if a <= self.layout.slots[link - 1] <= b}
        return [f"set_up_columns<{a}, {b}>(w);" for a, b in _expressions(ranges)]

    def _inward_abreast(self, limbs: Limbs) -> list[str]:
        """Sweep limbs inwards and leave what is found at the links that they hang on."""
        nears = [self.joints[first].parent for first in limbs.rows[0]]
        self.gathers.update(nears)
        sweep = f"inward_abreast<{self.p}, {self._number(limbs)}>(w);"
        left = [
            f"  leave<{self._starts(near)}>(w, {near}, lane(X, {lane}));"
            for lane, near in enumerate(nears, start=limbs.idle)
            if near > 0
        ]
        return ["{", f"  const auto X = {sweep}", *left, "}"] if left else [sweep]

    def _Propagate(self, steps: list[Propagate]) -> list[str]:  # noqa: N802
        return mobility.propagations(self.words, self.process, steps)

    def _Deliver(self, steps: list[Deliver]) -> list[str]:  # noqa: N802
        return mobility.deliveries(self.words, steps)

    def _SolveRoot(self, steps: list[SolveRoot]) -> list[str]:  # noqa: N802
        return [f"solve_root<{self.p}, {step.link}>(w);" for step in steps]

    def _Accelerate(self, steps: list[Accelerate]) -> list[str]:  # noqa: N802
        lines = []
        for run in units_of_sweep(self.joints, steps, self.limbs, outward_order):
            if isinstance(run, Limbs):
                self.parts |= {self.joints[first].parent for first in run.rows[0]}
                lines.append(f"accelerate_abreast<{self.p}, {self._number(run)}>(w);")
                continue
            self.parts.add(ends_of_run(self.joints, run)[0])
            call = sweep_of(self.joints, run, "accelerate", self.p)
            lines.append(call + self._names(run))
        return lines

    def _FreeAcceleration(self, steps: list[FreeAcceleration]) -> list[str]:  # noqa: N802
        self.parts |= {step.joint + 1 for step in steps}
        return [f"free_acceleration<{step.joint}>(w);" for step in steps]

    def _names(self, run: Run) -> str:
        """Which joints a run is of, as a comment."""
        return f"  // {self.words.span(run.first, run.last)}"


def _expressions(ranges: list[tuple[int, int]]) -> list[tuple[str, str]]:
    """First block of each range of slots, and the one behind its last, in C++."""
    return [(f"block({a})", f"block({b}) + 1") for a, b in ranges]


_WIDEST = 16  # joints in the widest block: two apart by less may share one
