"""What the template unrolled.cpp.j2 is told."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

from adagen.emit import guards
from adagen.emit.entries import entries_of, ranges, read_joints
from adagen.emit.processes import describe_message
from adagen.emit.unrolled.describe import describe_step
from adagen.emit.unrolled.layout import Chunk, Layout, Stretch, is_given, laid_out, looked_at
from adagen.emit.unrolled.text import FUNCTIONS, Text
from adagen.emit.words import Words
from adagen.executor import Simulated, simulate
from adagen.graph import Expression, live_nodes
from adagen.plan import Plan
from adagen.plan.stages import stages
from adagen.plan.steps import LinkBias, StartLink
from adagen.plan.types import Process

CHUNK = 1000
"""Values that one function computes, unless it is said otherwise."""


def why_not_unrolled(plan: Plan) -> str | None:
    """Return why a plan cannot be emitted in this shape, None if it can."""
    return "it computes in one number type" if plan.scalar == "mixed" else None


def unrolled_values(words: Words, chunk: int = 0) -> dict[str, object]:
    """Return what the template is told of a plan.

    Args:
        words: the plan's names.
        chunk: values that one function computes at most; by default what the words say, or CHUNK.
    """
    chunk = chunk or words.chunk or CHUNK
    plan = words.plan
    again = plan.recovering() if any(process.recovery for process in plan.processes) else None
    rows = [
        _ProcessText(words, p, process, simulated, chunk)
        for p, (process, simulated) in enumerate(
            zip(
                (*plan.processes, *(again.processes if again else ())),
                (*simulate(plan), *(simulate(again) if again else ())),
                strict=True,
            )
        )
    ]
    told = [row.values() for row in rows]
    functions = any(row.calls_functions() for row in rows)
    return {
        "runtime": ["status.hpp", *["kernels/lanes.hpp"] * words.batch],
        "functions": ["unrolled_functions.hpp"] * functions
        + ["unrolled_lane_functions.hpp"] * (functions and words.batch),
        "unrolled": told[: len(plan.processes)],
        "recovery": told[len(plan.processes) :],
        "places": max((row.layout.places for row in rows), default=0),
        "angle_count": max(len(row.machine.angles) for row in rows),
    }


class _ProcessText:
    """The functions of one process."""

    def __init__(
        self, words: Words, p: int, process: Process, simulated: Simulated, chunk: int
    ) -> None:
        self.words, self.p, self.machine = words, p, simulated.machine
        self.process = process
        self.owner = p % len(words.plan.processes)  # processes come again for their recovery
        self.graph = simulated.machine.graph
        self.operations = simulated.operations
        self.layout: Layout = laid_out(
            self.process, self.machine, simulated.ends, chunk, batch=words.batch
        )
        self.text = Text(self.graph, words.plan.scalar, self._only_users())
        self.followers = self._followers()
        self.functions: list[dict[str, object]] = []

    def values(self) -> dict[str, object]:
        """Return what the template is told of the process."""
        owned = list(self.process.owns)
        batch = self.words.batch
        return {
            "begin": self._prologue() if batch else [],
            "run": self._run(),
            "end": self._give() if batch else [],
            "functions": self.functions,
            "operations": self.operations,
            "read": read_joints(self.words, self.process),
            "owned": owned,
        }

    def calls_functions(self) -> bool:
        """Return whether its statements call functions of the runtime."""
        nodes = self.graph.nodes
        return any(nodes[k].op in FUNCTIONS for k in live_nodes(self.graph, self.machine.roots()))

    def _only_users(self) -> dict[int, int]:
        """By index, the value that is the one use of a value."""
        users: dict[int, list[int]] = defaultdict(list)
        for index in live_nodes(self.graph, self.machine.roots()):
            node = self.graph.nodes[index]
            for k in node.args:  # what is divided by keeps its name
                users[k] += [index] if node.op != "reciprocal" else [index, -1]
        for root in self.machine.roots():
            users[root.index].append(-1)
        return {k: using[0] for k, using in users.items() if len(using) == 1}

    def _followers(self) -> dict[int, list[str]]:
        """By index, the lines that follow a value once it is there."""
        lines: dict[int, list[str]] = defaultdict(list)
        for length, joint in self.machine.lengths:
            lines[length.index].append(f"require_length(w, x{length.index}, {joint});")
        for check in self.machine.checks:
            pivot, least = check.pivot, check.least
            if pivot.constant is None or pivot.constant <= (least.constant or 0):
                names = f"{self._name(pivot.index)}, {self._name(least.index)}"
                line = f"require_more(w, {names}, {check.failure}, {check.joint});"
                lines[(looked_at(check, self.layout.turns) or [pivot.index])[-1]].append(line)
        for number, content in self.machine.sent.items():
            for k, x in enumerate(content):
                lines[x.index].append(f"w.to[{number}][{k}] = {self._name(x.index)};")
        for joint, values in self.machine.results.items():
            v = self.words.plan.joints[joint].v
            for k, x in enumerate(values):
                lines[x.index].append(f"w.result[{v + k}] = {self._value(x.index)};")
        return lines

    def _name(self, index: int) -> str:
        node = self.graph.nodes[index]
        if node.op == "constant":
            return self.text.literal(node.value)
        return str(node.value) if is_given(node) else f"x{index}"

    def _value(self, index: int) -> str:
        """A value's name where one is put down: a number in all lanes."""
        constant = self.graph.nodes[index].op == "constant"
        return f"Value{{}} + {self._name(index)}" if constant else self._name(index)

    def _run(self) -> list[str]:
        """The lines of the function that does it all."""
        lines = ["stamp(0);", *self._prologue()] if self.process.steps else []
        found = stages(self.process)
        first = 0
        for place, stage in enumerate([*found, None]):
            if stage is not None and stage.message is None:
                continue
            lines += self._stretch(self.layout.stretches[place])
            # What runs between two messages is one line: its time counts for its last stage.
            lines += [f"stamp({k + 1});" for k in range(first, place)]
            first = place + 1
            if stage is not None and stage.message is not None:
                lines += [self._message(stage.what, stage.message), f"stamp({place + 1});"]
        return [*lines, *self._give()] if self.process.owns else lines

    def _prologue(self) -> list[str]:
        """The state is looked at; sines and cosines are taken of all angles at once."""
        lines = self._look_at_state()
        lines += [
            f"w.to[{number}] = channel.outgoing({number}, w.status);"
            for number in self.machine.sent
        ]
        angles = [self.text.inlined(angle.index) for angle in self.machine.angles]
        if angles:
            first = self._first_of_run(angles)
            if first is None:
                lines += [f"w.angle[{k}] = {angle};" for k, angle in enumerate(angles)]
            source = "w.angle.data()" if first is None else f"q + {first}"
            take = f"take_sines_and_cosines<{len(angles)}>"
            lines.append(f"{take}({source}, w.sine.data(), w.cosine.data());")
        # What is known beforehand, or is an input as it stands, is handed on right away.
        for index, followers in self.followers.items():
            node = self.graph.nodes[index]
            if node.op == "constant" or is_given(node):
                lines += followers
        return lines

    @staticmethod
    def _first_of_run(angles: Sequence[str]) -> int | None:
        """Where in q the angles are, one after the other; None if they are not."""
        for first in range(len(angles) + 1):
            if angles == [f"q[{first + k}]" for k in range(len(angles))]:
                return first
        return None

    def _look_at_state(self) -> list[str]:
        """The state looked at before all: as a whole where it is sent, or what nothing tells of."""
        words, process = self.words, self.process
        read = read_joints(words, process)
        looked_at = {
            "q": entries_of(words, "q", read),
            "v": entries_of(words, "v", read),
            "tau": entries_of(words, "v", process.owns),
        }
        if not guards.talks(process):
            told = self._told_of()
            looked_at = {
                name: [k for k in entries if f"{name}[{k}]" not in told]
                for name, entries in looked_at.items()
            }
        terms = [
            f"unlike_zero({name} + {first}, {count})"
            for name, entries in looked_at.items()
            for first, count in ranges(entries)
        ]
        lines = [f"if (!all({' + '.join(terms)} == 0))", f"  {self._names_state()}"] * bool(terms)
        return [*lines, *self._look_at_outer_forces()]

    def _names_state(self) -> str:
        return f"name_what_is_not_finite(w, kRead_{self.owner}, kOwned_{self.owner});"

    def _told_of(self) -> set[str]:
        """Inputs that are not finite only if an acceleration or what is checked is not, either.

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
        return {str(node.value) for node in nodes if is_given(node)}

    def _look_at_outer_forces(self) -> list[str]:
        plan = self.words.plan
        steps = self.process.steps
        links = {step.link for step in steps if isinstance(step, LinkBias | StartLink)}
        return [
            f"if (!all(unlike_zero(tau + {plan.entry_of_wrench(k)}, 6) == 0))"
            f" fail(w, kNotFinite, {wrench.link - 1});"
            for k, wrench in enumerate(plan.wrenches)
            if wrench.link in links
        ]

    def _give(self) -> list[str]:
        """An acceleration is given only where all went well."""
        owned = ranges(entries_of(self.words, "v", self.process.owns))
        terms = [f"unlike_zero(w.result.data() + {first}, {count})" for first, count in owned]
        amiss = f"!all({' + '.join(terms)} == 0)"
        overflow = f"name_what_overflows(w, kOwned_{self.owner});"
        if guards.talks(self.process):
            lines = [f"if ({amiss}) {overflow}"]
        else:
            amiss = f"__builtin_expect(w.status != kFine || {amiss}, 0)"
            lines = guards.in_hindsight(amiss, [self._names_state()], [overflow])
        return [
            *lines,
            "if (w.status != kFine) return;",
            *(f"std::copy_n(w.result.data() + {k}, {n}, w.qdd + {k});" for k, n in owned),
        ]

    def _message(self, what: str, number: int) -> str:
        message = self.words.plan.messages[number]
        about = describe_message(self.words, message)
        if what == "send":
            return f"channel.send({number}, w.status);  // to process {message.target}: {about}"
        return (
            f"w.from[{number}] = channel.receive({number}, w.status);"
            f"  // from process {message.source}: {about}"
        )

    def _stretch(self, stretch: Stretch) -> list[str]:
        run = []
        for chunk in stretch.chunks:
            name = f"part_{self.p}_{len(self.functions)}"
            self.functions.append({"name": name, "lines": self._chunk(chunk)})
            run.append(f"{name}(w);")
        return run

    def _chunk(self, chunk: Chunk) -> list[str]:
        """The statements of one function."""
        scalar = "Lanes" if self.words.batch else "Real"
        lines = [f"const {scalar} x{k} = w.x[{at}];" for k, at in sorted(chunk.loads.items())]
        mark = -1
        for index, right in self.text.statements(chunk.values).items():
            node = self.graph.nodes[index]
            if node.mark != mark:
                mark = node.mark
                lines.append(f"// {describe_step(self.words, self.process.steps[mark])}")
            lines.append(f"const {scalar} x{index} = {right};")
            if index in chunk.stores:
                lines.append(f"w.x[{chunk.stores[index]}] = x{index};")
            lines += self.followers.get(index, [])
        return lines
