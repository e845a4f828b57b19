"""Results of a straight line: accelerations, outputs and forces, single or in lanes."""

from __future__ import annotations

from collections import defaultdict

from adagen.emit import guards
from adagen.emit.processes import entries_of, given_entries, ranges
from adagen.emit.symbols import Symbols
from adagen.emit.unrolled.text import TYPES, Text
from adagen.executor import Machine
from adagen.plan.types import Process


class Results:
    """Stores the results of one process, and outputs them if there was no failure.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        process: the process.
        owner: whose results they are: what recovers counts on from the last process.
        machine: what simulated it.
        text: how values are written.
    """

    def __init__(
        self, symbols: Symbols, process: Process, owner: int, machine: Machine, text: Text
    ) -> None:
        self.symbols, self.process, self.owner = symbols, process, owner
        self.machine, self.text = machine, text
        self.forces = symbols.plan.force_entries(process)
        self.lanes = 0
        self.places = self._places_of_results()

    def lines(self) -> dict[int, list[str]]:
        """By index, the lines that store values as accelerations and outputs."""
        lines: dict[int, list[str]] = defaultdict(list)
        for first, force in self.machine.forces.items():
            for k, x in enumerate(force):
                lines[x.index].append(f"w.result[{first + k}] = {self.value(x.index)};")
        # A reproducible zero has no sign: whether one does depends on what is known beforehand.
        zero = " + Real(0)" if self.symbols.plan.reproducible else ""
        for joint, values in self.machine.results.items():
            v = self.symbols.plan.joints[joint].v
            for k, x in enumerate(values):
                place = self.places.get((joint, k))
                if place is None:
                    lines[x.index].append(f"w.result[{v + k}] = {self.value(x.index)}{zero};")
                else:
                    value = self.text.name(x.index)
                    if x.node.width == 1:  # the same in all lanes
                        value = f"{TYPES[self._width(joint)]}{{}} + {value}"
                    lines[x.index].append(f"put({value}{zero}, w.lanes.data() + {place});")
        for number, values in self.machine.outputs.items():
            first = self.symbols.plan.entry_of_output(number)
            for k, x in enumerate(values):
                lines[x.index].append(f"w.result[{first + k}] = {self.value(x.index)}{zero};")
        return lines

    def _width(self, joint: int) -> int:
        return len(self.machine.lanes_of_result(joint))

    def _places_of_results(self) -> dict[tuple[int, int], int]:
        """Places of rows' accelerations, by joint and freedom; the widest come first."""
        places: dict[tuple[int, int], int] = {}
        for joint in sorted(self.machine.results, key=lambda j: (-self._width(j), j)):
            for k in range(len(self.machine.results[joint])):
                if self._width(joint) > 1:
                    places[joint, k] = self.lanes
                    self.lanes += self._width(joint)
        return places

    def value(self, index: int) -> str:
        """A value's name where it is stored: a number in all lanes."""
        constant = self.machine.graph.nodes[index].op == "constant"
        return f"Value{{}} + {self.text.name(index)}" if constant else self.text.name(index)

    def give(self) -> list[str]:
        """Output of accelerations only if there was no failure."""
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
            lines = [f"if ({amiss}) {{", *(f"  {line}" for line in overflow[:-1])]
            lines += [f"  find_fault(w, kRead_{self.owner}, kOwned_{self.owner});", "}"]
        return [
            *lines,
            "if (w.status != kFine) return;",
            *(f"std::copy_n(w.result.data() + {k}, {n}, w.qdd + {k});" for k, n in single),
            *(f"w.qdd[{v}] = w.lanes[{at}];" for v, at in wide),
        ]

    def _single_results(self) -> list[tuple[int, int]]:
        """Ranges of accelerations that are single numbers."""
        rows = {j for joint, _ in self.places for j in self.machine.rows.own(joint)}
        wide = set(entries_of(self.symbols, "v", rows))
        own = [k for k in given_entries(self.symbols, self.process) if k not in wide]
        return ranges([*own, *self.forces])

    def _scattered(self) -> list[tuple[int, int]]:
        """Entries of the result that are computed in lanes, and their places.

        Where a process does all by itself, lanes may be of joints that others answer for.
        """
        joints, given = self.symbols.plan.joints, set(given_entries(self.symbols, self.process))
        return sorted(
            (joints[j].v + k, place + lane)
            for (joint, k), place in self.places.items()
            for lane, j in enumerate(self.machine.rows.own(joint))
            if joints[j].v + k in given
        )

    def _unlike_zero_in_lanes(self) -> list[str]:
        """Sums that are zero if all results in lanes are finite, for each width."""
        by_width: dict[int, list[int]] = defaultdict(list)
        for (joint, _), place in self.places.items():
            by_width[self._width(joint)].append(place)
        return [
            f"unlike_zero<{TYPES[width]}, {len(places)}>(w.lanes.data() + {places[0]})"
            for width, places in by_width.items()
        ]


def names_state(owner: int) -> str:
    """Return the line that tells which input of a process is not finite."""
    return f"name_what_is_not_finite(w, kRead_{owner}, kOwned_{owner});"
