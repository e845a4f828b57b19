"""The values of the template unrolled.cpp.j2."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Sequence

from adagen.emit import guards
from adagen.emit.messages import describe_message, message_size
from adagen.emit.processes import entries_of, given_entries, ranges, read_joints
from adagen.emit.symbols import Symbols
from adagen.emit.unrolled.arrangement import (
    Arrangement,
    Chunk,
    Stretch,
    arranged,
    is_given,
    is_swept,
    looked_at,
)
from adagen.emit.unrolled.results import Results, names_state
from adagen.emit.unrolled.swept import kept_lines, sweep_line, swept_values
from adagen.emit.unrolled.tangents import tangents
from adagen.emit.unrolled.text import FUNCTIONS, TYPES, Text, describe_step
from adagen.executor import Simulated, Swept, simulate
from adagen.executor import groupings as shared_limbs
from adagen.executor.checks import exceeds
from adagen.executor.lanes import Grouping
from adagen.graph import Expression, Node, live_nodes
from adagen.plan import Plan
from adagen.plan.arms import without_unlike
from adagen.plan.stages import stages
from adagen.plan.steps import LinkBias, StartLink
from adagen.plan.types import Process

_NAMES = re.compile(r"\bx(\d+)")
_NAMED = ("reciprocal", "pack", "lane", "across")
_ANGLES_AT_ONCE = 8  # as many are written as fill registers of 256 bits


def values(symbols: Symbols, chunk: int = 0) -> dict[str, object]:
    """Return the template's values for a plan.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        chunk: values that one function computes at most; by default what the program says, or as
            many as are best for one state or many.
    """
    chunk = chunk or symbols.chunk
    plan = symbols.plan
    plans = plan.alternatives
    groupings = [symbols.program.slots.limbs, *_recovering(symbols, plans[1:])]
    line = [
        one for each, limbs in zip(plans, groupings, strict=True) for one in simulate(each, limbs)
    ]
    processes = [process for each in plans for process in each.processes]
    wide = any(s.machine.rows.rows or s.machine.swept is not None for s in line)
    at_once = not (symbols.batch or symbols.embedded)  # sines of several angles in a register
    kept = max((s.machine.swept.places for s in line if s.machine.swept is not None), default=0)
    rows = [
        _ProcessText(symbols, p, process, simulated, chunk, at_once=at_once, kept=kept)
        for p, (process, simulated) in enumerate(zip(processes, line, strict=True))
    ]
    angles = max(len(row.machine.angles) for row in rows)
    angles = -(-angles // _ANGLES_AT_ONCE) * _ANGLES_AT_ONCE if at_once else angles
    swept = [row.machine.swept for row in rows if row.machine.swept is not None]
    angle_count = angles + max((one.lanes for one in swept), default=0)
    texts = [row.values(angle_count) for row in rows]
    tangent_count = max((len(table.places) for row in rows for table in row.tangents), default=0)
    of_friction = "embedded" if symbols.embedded else "take" if symbols.batch else "unrolled"
    functions = any(row.calls_functions() for row in rows)
    own = plan.reproducible  # sines, not those of the C library
    again = texts[len(plan.processes) :]
    return {
        "runtime": [
            *["reproducible.hpp"] * own,
            "far_angles_reduced.hpp" if own else "far_angles.hpp",
        ],
        "functions": [f"{of_friction}_tangents.hpp"] * bool(tangent_count)
        + ["unrolled_functions.hpp"] * functions
        + ["unrolled_lane_functions.hpp"] * (functions and symbols.batch)
        + ["multiply_add_lanes.hpp"] * (own and bool(symbols.batch or wide)),
        "unrolled": texts[: len(plan.processes)],
        "recovery": again,
        "again": [(text, f"_again_{k}", f"kRecoverParts_{k}") for k, text in enumerate(again)],
        "places": max((row.arrangement.places for row in rows), default=0),
        "swept": bool(swept),
        "angle_count": angle_count,
        "tangents": [table for row in rows for table in row.tangents],
        "tangent_count": tangent_count,
        "wide": wide,
        "as_it_stands": not symbols.batch,
        "wide_functions": ["unrolled_wide_functions.hpp"] * (functions and wide),
        "near_lock": not symbols.batch and any(c.near for s in line for c in s.machine.checks),
        "wide_results": max((row.results.lanes for row in rows), default=0),
    }


def _place_in(array: str, x: Expression) -> int:
    """The place of an input in an array."""
    return int(str(x.node.value).removeprefix(f"{array}[").removesuffix("]"))


def _recovering(symbols: Symbols, plans: Sequence[Plan]) -> list[Grouping]:
    """Return the limbs in lanes in each recovery; reproducible ones have those of their lines."""
    if symbols.plan.reproducible:
        return [shared_limbs(plan)[0 if symbols.batch else -1] for plan in plans]
    return [
        tuple(
            tuple(without_unlike(plan, process.steps, limbs))
            for process, limbs in zip(plan.processes, symbols.program.recovering, strict=False)
        )
        for plan in plans
    ]


class _ProcessText:
    """The functions of one process."""

    def __init__(
        self,
        symbols: Symbols,
        p: int,
        process: Process,
        simulated: Simulated,
        chunk: int,
        *,
        at_once: bool,
        kept: int,
    ) -> None:
        self.symbols, self.p, self.machine = symbols, p, simulated.machine
        self.at_once = at_once
        self.process = process
        self.owner = p % len(symbols.plan.processes)  # processes come again for their recovery
        self.graph = simulated.machine.graph
        self.operations = simulated.operations
        self.arrangement: Arrangement = arranged(
            self.process, simulated, chunk, None if symbols.batch else symbols.costs, kept=kept
        )
        self.text = Text(self.graph, symbols.plan.scalar, self._only_users())
        self.results = Results(symbols, process, self.owner, self.machine, self.text)
        self.followers = self._followers()
        self.tangents = tangents(p, self._scaled_rates(), symbols.plan.scalar)
        self.functions: list[dict[str, object]] = []

    def values(self, angles: int) -> dict[str, object]:
        """Return the template's values for the process, which has memory for so many angles."""
        owned = list(self.process.owns)
        batch = self.symbols.batch
        return {
            "begin": self._prologue() if batch else [],
            "run": self._run(),
            "end": self.results.give() if batch else [],
            "functions": self.functions,
            "operations": self.operations,
            "read": read_joints(self.symbols, self.process),
            "owned": owned,
            "angles": self._places_of_angles() if self.at_once else [],
            "swept": swept_values(self.machine.swept, self.text, angles - 1),
        }

    def calls_functions(self) -> bool:
        """Return whether its statements call functions of the runtime."""
        nodes = self.graph.nodes
        return any(nodes[k].op in FUNCTIONS for k in live_nodes(self.graph, self.machine.roots()))

    def _only_users(self) -> dict[int, int]:
        """By index, the only user of a value."""
        users: dict[int, list[int]] = defaultdict(list)
        for index in live_nodes(self.graph, self.machine.roots()):
            node = self.graph.nodes[index]
            for k in node.args:  # what is divided by, or moved into or out of lanes, keeps its name
                users[k] += [index] if node.op not in _NAMED else [index, -1]
        for root in self.machine.roots():
            users[root.index].append(-1)
        return {k: using[0] for k, using in users.items() if len(using) == 1}

    def _followers(self) -> dict[int, list[str]]:
        """By index, the lines after a value."""
        lines: dict[int, list[str]] = defaultdict(list)
        for length, joint in self.machine.lengths:
            line = f"require_length(w, x{length.index}, {self._blamed(length, joint)});"
            lines[length.index].append(line)
        for check in self.machine.checks:
            pivot, least = check.pivot, check.least
            if pivot.constant is None or not exceeds(pivot, least):
                names = f"{self.results.value(pivot.index)}, {self.text.name(least.index)}"
                blamed = self._blamed(pivot, check.joint)
                line = f"require_more(w, {names}, {check.failure}, {blamed});"
                after = lines[(looked_at(check, self.arrangement.turns) or [pivot.index])[-1]]
                after.append(line)
                if check.near and not self.symbols.batch:
                    name, near = self.text.name(pivot.index), f"Real({check.near!r})"
                    after.append(f"if ({name} < {near}) w.near_lock = {check.joint + 1};")
        for number, content in self.machine.sent.items():
            if not self.symbols.plan.reproducible:  # else these were counted
                room = message_size(self.symbols, self.symbols.plan.messages[number])
                assert len(content) <= room, f"{len(content)} numbers in a message for {room}"
            for k, x in enumerate(content):
                lines[x.index].append(f"w.to[{number}][{k}] = {self.text.name(x.index)};")
        for k, x in enumerate(self.machine.certificate):
            lines[x.index].append(f"w.certificate[{k}] = {self.results.value(x.index)};")
        for k, x in enumerate(self.machine.energies):
            lines[x.index].append(f"w.energies[{k}] = {self.results.value(x.index)};")
        for index, results in self.results.lines().items():
            lines[index] += results
        for index, left in kept_lines(self.machine, self.text).items():
            lines[index] += left
        return lines

    def _blamed(self, checked: Expression, joint: int) -> str:
        """The joint of a value's check, or the one of each lane."""
        if checked.node.width == 1:
            return str(joint)
        return f"{{{', '.join(map(str, self.machine.rows.own(joint)))}}}"

    def _run(self) -> list[str]:
        """The lines of the function that does everything."""
        lines = self._prologue() if self.process.steps else []
        found = stages(self.process)
        first = 0
        for place, stage in enumerate([*found, None]):
            if stage is not None and stage.message is None:
                continue
            lines += self._stretch(self.arrangement.stretches[place])
            # What runs between two messages is one line: its time counts for its last stage.
            lines += [f"stamp({k + 1});" for k in range(first, place)]
            first = place + 1
            if stage is not None and stage.message is not None:
                lines += [self._message(stage.what, stage.message), f"stamp({place + 1});"]
        lines += ["judge_corrections(w);"] * bool(self.machine.energies)
        if self.machine.swept is not None:
            lines += self._after_sweep(self.machine.swept)
        return (
            [*lines, *self.results.give()] if given_entries(self.symbols, self.process) else lines
        )

    def _after_sweep(self, swept: Swept) -> list[str]:
        """The sweep of residuals by a loop, and what waits for it."""
        nodes = self.graph.nodes
        at_once = [own for k, own in self.followers.items() if is_swept(nodes[k])]
        return [
            sweep_line(swept, self.p),
            *(line for own in at_once for line in own),
            *self._stretch(self.arrangement.after),
        ]

    def _prologue(self) -> list[str]:
        """Reading of the state; sines, cosines and tangents of all joints are computed at once."""
        lines = self._look_at_state()
        lines += [
            f"w.to[{number}] = channel.outgoing({number}, w.status);"
            for number in self.machine.sent
        ]
        angles = [self.text.inlined(angle.index) for angle in self.machine.angles]
        if angles and self.at_once:
            source = "q"
            if not self._angles_are_given():
                source = "w.angle.data()"
                lines += [f"w.angle[{k}] = {angle};" for k, angle in enumerate(angles)]
            arguments = f"{source}, kAngles_{self.p}, w.sine.data(), w.cosine.data()"
            lines.append(f"take_sines_and_cosines({arguments});")
        elif angles:
            first = self._first_of_run(angles)
            if first is None:
                lines += [f"w.angle[{k}] = {angle};" for k, angle in enumerate(angles)]
            source = "w.angle.data()" if first is None else f"q + {first}"
            take = f"take_sines_and_cosines<{len(angles)}>"
            lines.append(f"{take}({source}, w.sine.data(), w.cosine.data());")
        for table in self.tangents:
            lines.append(f"take_tangents(v, kTangents_{table.process}, w.tangent.data());")
        # What is known beforehand, or is an input as it stands, is passed on right away.
        for index, followers in self.followers.items():
            node = self.graph.nodes[index]
            if (node.op == "constant" or is_given(node)) and not is_swept(node):
                lines += followers
        return lines

    def _scaled_rates(self) -> list[tuple[int, str]]:
        """Places in v of the rates whose tangents are taken, and the factors of these."""
        return [
            (_place_in("v", rate), self.text.literal(factor.constant))
            for rate, factor in self.machine.tangents
        ]

    def _angles_are_given(self) -> bool:
        return all(is_given(angle.node) for angle in self.machine.angles)

    def _places_of_angles(self) -> list[int]:
        """Indices of angles: in q, or in turn where some are computed first."""
        if not self._angles_are_given():
            return list(range(len(self.machine.angles)))
        return [_place_in("q", angle) for angle in self.machine.angles]

    @staticmethod
    def _first_of_run(angles: Sequence[str]) -> int | None:
        """Index in q of the first angle if all are adjacent, else None."""
        for first in range(len(angles) + 1):
            if angles == [f"q[{first + k}]" for k in range(len(angles))]:
                return first
        return None

    def _look_at_state(self) -> list[str]:
        """Tests of the state before all: of all that is sent, or that no later test covers."""
        symbols, process = self.symbols, self.process
        read = read_joints(symbols, process)
        looked_at = {
            "q": entries_of(symbols, "q", read),
            "v": entries_of(symbols, "v", read),
            "tau": entries_of(symbols, "v", process.owns),
        }
        if not guards.talks(process):
            stored = self._stored_in()
            looked_at = {
                name: [k for k in entries if f"{name}[{k}]" not in stored]
                for name, entries in looked_at.items()
            }
        terms = [
            f"unlike_zero({name} + {first}, {count})"
            for name, entries in looked_at.items()
            for first, count in ranges(entries)
        ]
        amiss = f"if (!all({' + '.join(terms)} == 0))"
        lines = [amiss, f"  {names_state(self.owner)}"] * bool(terms)
        return [*lines, *self._look_at_outer_forces()]

    def _stored_in(self) -> set[str]:
        """Inputs whose NaN always reaches an acceleration or a tested value.

        All that is reckoned from them is spoilt: only a division by what is infinite would mend it,
        and what is divided by is checked.
        """
        names = self._inputs_of(self.machine.roots())
        angles = [
            angle
            for k, angle in enumerate(self.machine.angles)
            if not names.isdisjoint((f"sine[{k}]", f"cosine[{k}]"))
        ]
        return names | self._inputs_of(angles)

    def _inputs_of(self, roots: Sequence[Expression]) -> set[str]:
        nodes = [self.graph.nodes[k] for k in live_nodes(self.graph, roots)]
        names: set[str] = set()
        for node in nodes:
            if is_given(node):
                array, place = str(node.value).removesuffix("]").split("[")
                names.update(f"{array}[{int(place) + k}]" for k in range(node.width))
        return names

    def _look_at_outer_forces(self) -> list[str]:
        plan = self.symbols.plan
        steps = self.process.steps
        links = {step.link for step in steps if isinstance(step, LinkBias | StartLink)}
        return [
            f"if (!all(unlike_zero(tau + {plan.entry_of_wrench(k)}, 6) == 0))"
            f" fail(w, kNotFinite, {wrench.link - 1});"
            for k, wrench in enumerate(plan.wrenches)
            if wrench.link in links
        ]

    def _message(self, what: str, number: int) -> str:
        message = self.symbols.plan.messages[number]
        about = describe_message(self.symbols, message)
        if what == "send":
            return f"channel.send({number}, w.status);  // to process {message.target}: {about}"
        plan = self.symbols.plan
        ways = plan.reproducible and plan.closed  # which one to go is heard, whatever failed here
        call = f"heard(w, channel, {number})" if ways else f"channel.receive({number}, w.status)"
        return f"w.from[{number}] = {call};  // from process {message.source}: {about}"

    def _stretch(self, stretch: Stretch) -> list[str]:
        run = []
        for chunk in stretch.chunks:
            name = f"part_{self.p}_{len(self.functions)}"
            self.functions.append({"name": name, "lines": self._chunk(chunk)})
            run.append(f"{name}(w);")
        return run

    def _chunk(self, chunk: Chunk) -> list[str]:
        """The statements of one function.

        What another function has stored is loaded right before its first use: loaded at the
        beginning, most of it would go through memory once more, as there are so few registers.
        """
        lines: list[str] = []
        loads = dict(chunk.loads)
        named = self._named(chunk)
        mark = -1
        for index, right in self.text.statements(chunk.values).items():
            node = self.graph.nodes[index]
            if node.mark != mark:
                mark = node.mark
                step, row = self.process.steps[mark], self.machine.rows.own
                lines.append(f"// {describe_step(self.symbols, step, row)}")
            if self.symbols.batch and self._known(node):
                right = f"Value{{}} + {right}"  # no number in any lane
            if index in chunk.stores:
                right = self._stored(index, right, chunk.stores[index])
            name = f"const {self._type(index)} x{index} = " if index in named else ""
            own = [f"{name}{right};", *self.followers.get(index, [])]
            first = sorted({k for line in own for k in _names(line)} & loads.keys())
            lines += [self._load(k, loads.pop(k)) for k in first]
            lines += own
        return lines

    def _known(self, node: Node) -> bool:
        """Whether a value depends on constants only: it then divides by zero."""
        return bool(node.args) and all(self.graph.nodes[k].op == "constant" for k in node.args)

    def _named(self, chunk: Chunk) -> set[int]:
        """The values of a function that it uses itself: all but some for other functions."""
        lines = " ".join(line for k in chunk.values for line in self.followers.get(k, []))
        used = set(_names(lines))
        used.update(k for index in chunk.values for k in self.graph.nodes[index].args)
        return used | (set(chunk.values) - set(chunk.stores))

    def _type(self, index: int) -> str:
        return "Lanes" if self.symbols.batch else TYPES[self.graph.nodes[index].width]

    def _load(self, index: int, place: int) -> str:
        if self.graph.nodes[index].width == 1:
            return f"const {self._type(index)} x{index} = w.x[{place}];"
        kind = self._type(index)
        return f"const {kind} x{index} = load<{kind}>(w.x.data() + {place});"

    def _stored(self, index: int, right: str, place: int) -> str:
        """A value that is stored for another function where it is computed."""
        if self.graph.nodes[index].width == 1:
            return f"w.x[{place}] = {right}"
        return f"put({right}, w.x.data() + {place})"


def _names(text: str) -> list[int]:
    """The indices of the values that are named in a text."""
    return [int(number) for number in _NAMES.findall(text)]
