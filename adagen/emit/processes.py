"""What each process reads and owns of the state, and what its messages are about."""

from __future__ import annotations

from dataclasses import dataclass

from adagen.emit import effects
from adagen.emit.entries import Range, entries_of, given_entries, ranges, read_joints
from adagen.emit.stages import stage_rows
from adagen.emit.words import Words
from adagen.executor import simulate
from adagen.plan.steps import LinkBias, StartLink
from adagen.plan.types import Message, Process

_NAMED = 6  # joints that a summary names before it only counts


def process_rows(words: Words) -> list[dict[str, object]]:
    """Return what the template says of each process."""
    return [
        {
            "summary": _summary(words, process),
            "stages": stage_rows(process),
            "tables": _tables(words, p, process),
            "info": ", ".join(
                f"{{{table.count}, {table.name}.data()}}" if table.ranges else "{0, nullptr}"
                for table in _tables(words, p, process)
            ),
        }
        for p, process in enumerate(words.plan.processes)
    ]


def _summary(words: Words, process: Process) -> str:
    if not process.owns:
        return "has nothing to do"
    names = [words.quoted_joint(j) for j in process.owns[:_NAMED]]
    more = ", ..." if len(process.owns) > _NAMED else ""
    shared = len(process.shares)
    core = f"; {shared} more that every process computes for itself" if shared else ""
    passing = len(process.reads) - len(process.owns) - shared
    path = f"; kinematics of {passing} more on the way to the ground" if passing else ""
    if process.spares:
        path = "; all of them in a singular pose"
    own = f"{len(process.owns)} of {len(words.plan.joints)} joints: {', '.join(names)}{more}"
    return f"{own}{core}{path}"


def describe_message(words: Words, message: Message) -> str:
    """Return what a message is about, in a few words."""
    if message.joint is None:
        what = "accelerations" if message.sweep == "slaved" else "torques"
        return f"{what} of slaved joints"
    if message.inertias:
        links = ", ".join(words.quoted_link(link) for link in message.inertias)
        return f"what hangs on {links}"
    if message.passages:
        spans = (words.span(own.first, own.last) for own in message.passages)
        return f"how {', '.join(spans)} move their last link"
    what = "assembled" if message.sweep == "assembly" else "forces on"
    return f"{what}: chain of {words.quoted_joint(message.joint)}"


def message_size(words: Words, message: Message) -> int:
    """Return the numbers in a message, at least one."""
    if words.plan.reproducible:
        source = simulate(words.plan, words.program.slots.limbs)[message.source]
        return max(1, len(source.machine.sent[words.plan.messages.index(message)]))
    whole = message.joint is None  # of slaved joints: all right-hand sides together
    return message.numbers(words.plan.right_hand_sides if whole else words.columns)


@dataclass(frozen=True)
class _Table:
    """Entries of a vector that a process needs, as ranges (first, count)."""

    name: str
    ranges: list[Range]

    @property
    def count(self) -> int:
        return len(self.ranges)

    @property
    def entries(self) -> int:
        return sum(count for _, count in self.ranges)


def _tables(words: Words, p: int, process: Process) -> list[_Table]:
    """What a process reads of q and v (a slaved joint's from its source), and its own entries."""
    read = read_joints(words, process)
    q, v = entries_of(words, "q", read), entries_of(words, "v", read)
    own = [*given_entries(words, process), *words.plan.force_entries(process)]
    torques = entries_of(words, "v", (*process.owns, *process.shares, *process.spares))
    links = {step.link for step in process.steps if isinstance(step, LinkBias | StartLink)}
    torques += effects.pushed_entries(words, links)
    return [
        _Table(f"{name}_{p}", ranges(entries))
        for name, entries in (("kReadQ", q), ("kReadV", v), ("kOwn", own), ("kTorque", torques))
    ]


def table_sizes(words: Words, process: Process) -> tuple[int, int]:
    """Return the numbers that process 0 sends it of the state, and that it sends back."""
    q, v, own, torques = (table.entries for table in _tables(words, 0, process))
    return q + v + torques, own
