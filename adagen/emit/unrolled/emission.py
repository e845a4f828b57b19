"""What the template unrolled.cpp.j2 is told."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

from adagen.emit import guards
from adagen.emit.entries import entries_of, given_entries, ranges, read_joints
from adagen.emit.processes import describe_message
from adagen.emit.unrolled.describe import describe_step
from adagen.emit.unrolled.layout import Chunk, Layout, Stretch, is_given, laid_out, looked_at
from adagen.emit.unrolled.text import FUNCTIONS, TYPES, Text
from adagen.emit.words import Words
from adagen.executor import Simulated, simulate
from adagen.executor.checks import exceeds
from adagen.executor.lanes import Grouping
from adagen.graph import Expression, live_nodes
from adagen.plan import Plan
from adagen.plan.alike import without_unlike
from adagen.plan.stages import stages
from adagen.plan.steps import LinkBias, StartLink
from adagen.plan.types import Process

CHUNK = 1000
"""Values that one function computes, unless it is said otherwise."""

_NAMED = ("reciprocal", "pack", "lane", "across")
_ANGLES_AT_ONCE = 16  # the most that registers hold


def why_not(plan: Plan) -> str | None:
    """Return why a plan cannot be emitted in this shape, None if it can."""
    return "it computes in one number type" if plan.scalar == "mixed" else None


def values(words: Words, chunk: int = 0) -> dict[str, object]:
    """Return what the template is told of a plan.

    Args:
        words: the plan's names.
        chunk: values that one function computes at most; by default what the words say, or CHUNK.
    """
    chunk = chunk or words.chunk or CHUNK
    plan = words.plan
    plans = plan.alternatives
    groupings = [words.program.slots.limbs, *_recovering(words, plans[1:])]
    line = [
        one for each, limbs in zip(plans, groupings, strict=True) for one in simulate(each, limbs)
    ]
    processes = [process for each in plans for process in each.processes]
    wide = any(simulated.machine.rows.rows for simulated in line)
    sines_in_lanes = wide or (plan.reproducible and not words.batch)
    rows = [
        _ProcessText(words, p, process, simulated, chunk, wide=sines_in_lanes)
        for p, (process, simulated) in enumerate(zip(processes, line, strict=True))
    ]
    angles = max(len(row.machine.angles) for row in rows)
    told = [row.values() for row in rows]
    functions = any(row.calls_functions() for row in rows)
    own = plan.reproducible  # sines and tangents, not those of the C library
    lanes = ["far_angles_reduced.hpp" if own else "far_angles.hpp", "kernels/lanes.hpp"]
    return {
        "runtime": [
            *["reproducible.hpp"] * own,
            *("status.hpp", "failures.hpp"),
            *lanes * (words.batch or sines_in_lanes),
        ],
        "functions": ["tanh_own.hpp" if own else "tanh_library.hpp", "unrolled_functions.hpp"]
        * functions
        + ["unrolled_lane_functions.hpp"] * (functions and words.batch),
        "unrolled": told[: len(plan.processes)],
        "recovery": told[len(plan.processes) :],
        "places": max((row.layout.places for row in rows), default=0),
        "angle_count": -(-angles // _ANGLES_AT_ONCE) * _ANGLES_AT_ONCE
        if sines_in_lanes
        else angles,
        "wide": wide,
        "wide_functions": ["unrolled_wide_functions.hpp"] * (functions and wide),
        "sines_in_lanes": sines_in_lanes,
        "near_lock": not words.batch and any(c.near for s in line for c in s.machine.checks),
        "wide_results": max((row.count_of_lanes for row in rows), default=0),
    }


def _recovering(words: Words, plans: Sequence[Plan]) -> list[Grouping]:
    """Return the limbs that share code in what is done instead, in each of several ways."""
    return [
        tuple(
            tuple(without_unlike(plan, process.steps, limbs))
            for process, limbs in zip(plan.processes, words.program.recovering, strict=False)
        )
        for plan in plans
    ]


class _ProcessText:
    """The functions of one process."""

    def __init__(
        self,
        words: Words,
        p: int,
        process: Process,
        simulated: Simulated,
        chunk: int,
        *,
        wide: bool,
    ) -> None:
        self.words, self.p, self.machine, self.wide = words, p, simulated.machine, wide
        self.process = process
        self.owner = p % len(words.plan.processes)  # processes come again for their recovery
        self.forces = words.plan.force_entries(process)
        self.graph = simulated.machine.graph
        self.operations = simulated.operations
        self.layout: Layout = laid_out(
            self.process, self.machine, simulated.ends, chunk, batch=words.batch
        )
        self.text = Text(self.graph, words.plan.scalar, self._only_users())
        self.count_of_lanes = 0
        self.wide_results = self._places_of_results()
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
            "angles": self._places_of_angles() if self.wide else [],
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
            for k in node.args:  # what is divided by, or moved into or out of lanes, keeps its name
                users[k] += [index] if node.op not in _NAMED else [index, -1]
        for root in self.machine.roots():
            users[root.index].append(-1)
        return {k: using[0] for k, using in users.items() if len(using) == 1}

    def _followers(self) -> dict[int, list[str]]:
        """By index, the lines that follow a value once it is there."""
        lines: dict[int, list[str]] = defaultdict(list)
        for length, joint in self.machine.lengths:
            line = f"require_length(w, x{length.index}, {self._blamed(length, joint)});"
            lines[length.index].append(line)
        for check in self.machine.checks:
            pivot, least = check.pivot, check.least
            if pivot.constant is None or not exceeds(pivot, least):
                names = f"{self.text.name(pivot.index)}, {self.text.name(least.index)}"
                blamed = self._blamed(pivot, check.joint)
                line = f"require_more(w, {names}, {check.failure}, {blamed});"
                after = lines[(looked_at(check, self.layout.turns) or [pivot.index])[-1]]
                after.append(line)
                if check.near and not self.words.batch:
                    name, near = self.text.name(pivot.index), f"Real({check.near!r})"
                    after.append(f"if ({name} < {near}) w.near_lock = {check.joint + 1};")
        for number, content in self.machine.sent.items():
            for k, x in enumerate(content):
                lines[x.index].append(f"w.to[{number}][{k}] = {self.text.name(x.index)};")
        for k, x in enumerate(self.machine.certificate):
            lines[x.index].append(f"w.certificate[{k}] = {self._value(x.index)};")
        for index, results in self._results().items():
            lines[index] += results
        return lines

    def _results(self) -> dict[int, list[str]]:
        """By index, the lines that put values down as accelerations and outputs."""
        lines: dict[int, list[str]] = defaultdict(list)
        for first, force in self.machine.forces.items():
            for k, x in enumerate(force):
                lines[x.index].append(f"w.result[{first + k}] = {self._value(x.index)};")
        # A reproducible zero has no sign: whether one does depends on what is known beforehand.
        zero = " + Real(0)" if self.words.plan.reproducible else ""
        for joint, values in self.machine.results.items():
            v = self.words.plan.joints[joint].v
            for k, x in enumerate(values):
                place = self.wide_results.get((joint, k))
                if place is None:
                    lines[x.index].append(f"w.result[{v + k}] = {self._value(x.index)}{zero};")
                else:
                    value = self.text.name(x.index)
                    if x.node.width == 1:  # the same in all lanes
                        value = f"{TYPES[self._width(joint)]}{{}} + {value}"
                    lines[x.index].append(f"put({value}{zero}, w.lanes.data() + {place});")
        for number, values in self.machine.outputs.items():
            first = self.words.plan.entry_of_output(number)
            for k, x in enumerate(values):
                lines[x.index].append(f"w.result[{first + k}] = {self._value(x.index)}{zero};")
        return lines

    def _width(self, joint: int) -> int:
        return len(self.machine.lanes_of_result(joint))

    def _places_of_results(self) -> dict[tuple[int, int], int]:
        """Where rows' accelerations are kept, by joint and freedom; the widest come first."""
        places: dict[tuple[int, int], int] = {}
        for joint in sorted(self.machine.results, key=lambda j: (-self._width(j), j)):
            for k in range(len(self.machine.results[joint])):
                if self._width(joint) > 1:
                    places[joint, k] = self.count_of_lanes
                    self.count_of_lanes += self._width(joint)
        return places

    def _blamed(self, checked: Expression, joint: int) -> str:
        """The joint that a value is checked for, or the one of each lane."""
        if checked.node.width == 1:
            return str(joint)
        return f"{{{', '.join(map(str, self.machine.rows.own(joint)))}}}"

    def _value(self, index: int) -> str:
        """A value's name where one is put down: a number in all lanes."""
        constant = self.graph.nodes[index].op == "constant"
        return f"Value{{}} + {self.text.name(index)}" if constant else self.text.name(index)

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
        return [*lines, *self._give()] if given_entries(self.words, self.process) else lines

    def _prologue(self) -> list[str]:
        """The state is looked at; sines and cosines are taken of all angles at once."""
        lines = self._look_at_state()
        lines += [
            f"w.to[{number}] = channel.outgoing({number}, w.status);"
            for number in self.machine.sent
        ]
        angles = [self.text.inlined(angle.index) for angle in self.machine.angles]
        if angles and self.wide:
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
        # What is known beforehand, or is an input as it stands, is handed on right away.
        for index, followers in self.followers.items():
            node = self.graph.nodes[index]
            if node.op == "constant" or is_given(node):
                lines += followers
        return lines

    def _angles_are_given(self) -> bool:
        return all(is_given(angle.node) for angle in self.machine.angles)

    def _places_of_angles(self) -> list[int]:
        """Where angles are found: in q, or by turns where some are computed first."""
        if not self._angles_are_given():
            return list(range(len(self.machine.angles)))
        names = (str(angle.node.value) for angle in self.machine.angles)
        return [int(name.removeprefix("q[").removesuffix("]")) for name in names]

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
        names: set[str] = set()
        for node in nodes:
            if is_given(node):
                array, place = str(node.value).removesuffix("]").split("[")
                names.update(f"{array}[{int(place) + k}]" for k in range(node.width))
        return names

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
        single, wide = self._single_results(), self._scattered()
        terms = [f"unlike_zero(w.result.data() + {first}, {count})" for first, count in single]
        terms += self._unlike_zero_in_lanes()
        amiss = f"!all({' + '.join(terms)} == 0)"
        overflow = [f"name_what_overflows(w, kOwned_{self.owner});"]
        if wide:
            overflow = [*(f"w.result[{v}] = w.lanes[{at}];" for v, at in wide), *overflow]
        if guards.talks(self.process):
            lines = [f"if ({amiss}) {{", *(f"  {line}" for line in overflow), "}"]
            lines = lines if wide else [f"if ({amiss}) {overflow[0]}"]
        else:
            amiss = f"__builtin_expect(w.status != kFine || {amiss}, 0)"
            lines = guards.in_hindsight(amiss, [self._names_state()], overflow)
        return [
            *lines,
            "if (w.status != kFine) return;",
            *(f"std::copy_n(w.result.data() + {k}, {n}, w.qdd + {k});" for k, n in single),
            *(f"w.qdd[{v}] = w.lanes[{at}];" for v, at in wide),
        ]

    def _single_results(self) -> list[tuple[int, int]]:
        """Ranges of accelerations that are computed by themselves."""
        rows = {j for joint, _ in self.wide_results for j in self.machine.rows.own(joint)}
        wide = set(entries_of(self.words, "v", rows))
        own = [k for k in given_entries(self.words, self.process) if k not in wide]
        return ranges([*own, *self.forces])

    def _scattered(self) -> list[tuple[int, int]]:
        """Entries of the result that are computed in lanes, and where they are kept."""
        joints = self.words.plan.joints
        return sorted(
            (joints[j].v + k, place + lane)
            for (joint, k), place in self.wide_results.items()
            for lane, j in enumerate(self.machine.rows.own(joint))
            if self.words.plan.wants(j)
        )

    def _unlike_zero_in_lanes(self) -> list[str]:
        """Sums that are zero if what is computed in lanes is finite, for each width."""
        by_width: dict[int, list[int]] = defaultdict(list)
        for (joint, _), place in self.wide_results.items():
            by_width[self._width(joint)].append(place)
        return [
            f"unlike_zero<{TYPES[width]}, {len(places)}>(w.lanes.data() + {places[0]})"
            for width, places in by_width.items()
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
        lines = [self._load(k, at) for k, at in sorted(chunk.loads.items())]
        mark = -1
        for index, right in self.text.statements(chunk.values).items():
            node = self.graph.nodes[index]
            if node.mark != mark:
                mark = node.mark
                lines.append(f"// {self._described(mark)}")
            lines.append(f"const {self._type(index)} x{index} = {right};")
            if index in chunk.stores:
                lines.append(self._store(index, chunk.stores[index]))
            lines += self.followers.get(index, [])
        return lines

    def _described(self, mark: int) -> str:
        return describe_step(self.words, self.process.steps[mark], self.machine.rows.own)

    def _type(self, index: int) -> str:
        return "Lanes" if self.words.batch else TYPES[self.graph.nodes[index].width]

    def _load(self, index: int, place: int) -> str:
        if self.graph.nodes[index].width == 1:
            return f"const {self._type(index)} x{index} = w.x[{place}];"
        kind = self._type(index)
        return f"const {kind} x{index} = taken<{kind}>(w.x.data() + {place});"

    def _store(self, index: int, place: int) -> str:
        if self.graph.nodes[index].width == 1:
            return f"w.x[{place}] = x{index};"
        return f"put(x{index}, w.x.data() + {place});"
