"""Costs of the steps of a plan on a machine: the coefficients of a measured cost profile.

Eq. (11) prices a join as a whole, in the paper's form of the algorithm. A machine spends its time
on steps (kinematics, articulated bodies, joins, messages), each of which costs a base per joint
kind and something for every handle that takes part. docs/reference/cost_profiles.md describes the
file.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from functools import cached_property

from adagen.model.kinds import KINDS
from adagen.tomlfile import Source

PRESCRIBED = "prescribed"
"""What a joint of known acceleration is priced as, whatever its kind: to forces it is rigid."""

LIMIT, LIMIT_OF_SIZES = 1e6, 1e9
"""Most microseconds that a coefficient may be, and most bytes of a cache."""

REPEATED = "join_repeated"
"""Joins of form `ada`."""
BATCH = "batch"
"""Registers of which each lane holds a state."""
_JOINED = (PRESCRIBED, "ground", "coupling_a", "coupling_b", "block", "across")
PER_KIND: dict[str, tuple[str, ...]] = {
    "kinematics": ("run", "step"),
    "join": _JOINED,
    REPEATED: _JOINED,
    "disassemble": (PRESCRIBED, "ground", "coupling"),
    "articulate": (PRESCRIBED, "ground", "reversed", "run", "turned"),
    "propagate": (PRESCRIBED, "ground", "reversed", "spread"),
    "deliver": (PRESCRIBED, "reversed", "load", "along"),
    "accelerate": (PRESCRIBED, "reversed", "run"),
    **{
        f"{group}_{number}": ()
        for group in ("kinematics", "articulate", "accelerate")
        for number in ("two", "four")
    },
    "articulate_columns": ("run",),
    "kinematics_strips": ("run",),
    "kinematics_traversed": ("run",),
    "passing_strips": (),
    "propagate_run": ("run", "product"),
    "propagate_along": (),
    BATCH: ("turned", "weighed", "operation", "sine", "tangent", "number"),
}
"""Groups with a coefficient per joint kind, and what else each has.

A joint of known acceleration costs ``prescribed`` whatever its kind, and one on the ground
``ground``; ``reversed`` is added where the segment's root lies below the joint, ``run`` once for
every run of joints, ``turned`` for every joint of what is swept in the joints' own axes, and
``step`` where the kinematics of a joint are a call of their own; the others are per handle, block
or coupling. ``join_repeated`` prices the joins of form `ada`: they follow each other, so that their
code is at hand, which that of the few joins between processes is not. What ends on a number prices
a row of as many joints, passed side by side; the limbs that they belong to cost something besides,
once for each sweep (``limbs``; ``limbs.turned`` for each row that is swept in the joints' own
axes). ``articulate_columns`` is for joints of runs that are computed by columns,
``kinematics_strips`` of runs passed outwards in strips, ``passing_strips`` of those that are only
passed on the way to others, ``kinematics_traversed`` of those whose strips a traversal has found
before, and ``propagate_run`` of runs whose mobility is asked for at the last link only; ``product``
is a product of 6x6 matrices that they need beyond their joints and ``run``. ``propagate_along`` is
the same where unit wrenches go along with the sweep inwards, by columns; ``deliver.along`` brings a
force to a joint of such a run. ``batch`` prices a register full of states, not their parts: in
loops their joints (``turned`` is added for each in its own axes, ``weighed`` for each where answers
are certified), in straight lines their operations and angles, and in both the tangents that
friction asks for, and the numbers that are moved into lanes and out of them.
"""

OTHERS: dict[str, tuple[str, ...]] = {
    "link": ("bias", "start"),
    "root": ("invert", "solve", "accelerate", "mobility"),
    "free": ("base", "acceleration"),
    "slaved": ("solve", "apply", "column"),
    "limbs": ("two", "four", "nested_inwards", "nested_outwards", "turned"),
    "parts": ("inwards", "outwards", "run", "join", "release"),
    "process": ("evaluation", "tangent", "margin", "cache", "register"),
    "unrolled": (
        *("evaluation", "operation", "move", "sine", "cycle", "fetched", "held"),
        *("evicted", "fits", "cache", "ahead", "urgent"),
    ),
}
"""Groups with coefficients of their own, times but for nine.

``process.tangent`` is added for every rate of a joint with friction, in loops and straight lines.
``slaved.column`` and ``process.margin`` are shares, ``unrolled.held`` and ``unrolled.fits`` are
numbers of statements, ``unrolled.urgent`` is one of values, ``unrolled.cache`` is the size of a
core's first instruction cache in bytes, ``process.cache`` that of its second-level cache
(adagen/schedule/caches.py), ``process.register`` that of its widest registers, and
``unrolled.ahead`` is how many values are looked at for those that others wait for
(adagen/emit/unrolled/order.py).

``unrolled`` prices no steps but a straight line of statements as a whole (shape `unrolled`);
``fetched`` is added for each statement beyond those whose decoded instructions are held, and
``evicted`` for each statement of a line that the first instruction cache does not fit: from
beginning to end, its instructions displace those that come next. Lines of up to ``urgent``
values are ordered by what waits, longer ones by step.
"""

ASSUMED = {
    "unrolled.evicted": 0.0,
    "unrolled.fits": LIMIT,
    "unrolled.cache": 65536.0,
    "unrolled.ahead": 2000.0,
    "unrolled.urgent": LIMIT,
    "process.tangent": 0.0025,
    "process.cache": 2097152.0,
    "process.register": 64.0,
    "batch.revolute": 0.064,
    "batch.prismatic": 0.0479,
    "batch.spherical": 0.0651,
    "batch.planar": 0.112,
    "batch.floating": 0.0813,
    "batch.turned": 0.0423,
    "batch.weighed": 0.0337,
    "batch.operation": 0.000139,
    "batch.sine": 0.00326,
    "batch.tangent": 0.00669,
    "batch.number": 0.00136,
}
"""What holds where a profile says nothing: it was measured without lines of such a length and
without batches, and the machine's caches and registers are not known, nor which order of values is
the faster one."""
LIKE = {REPEATED: "join"}
"""Groups that a profile may leave out, and the groups whose coefficients hold for them then."""

GROUPS: dict[str, tuple[str, ...]] = {
    **{group: (*KINDS, *extra) for group, extra in PER_KIND.items()},
    **OTHERS,
}
"""The coefficients of each group."""

NAMES: tuple[str, ...] = tuple(f"{group}.{key}" for group, keys in GROUPS.items() for key in keys)
"""All coefficients of a step profile, as group.key."""

CHANNELS = ("window", "message")
NETWORK = "network"
"""The channel between hosts, which a profile may have besides."""
CHANNEL_KEYS = ("send", "latency", "number")


@dataclass(frozen=True)
class ChannelCosts:
    """Costs of a message, in microseconds.

    Attributes:
        send: time of the sender, whatever the message holds.
        latency: from sent to seen.
        number: per number, to put it in and again to take it out.
    """

    send: float
    latency: float
    number: float

    def __post_init__(self) -> None:
        for key in CHANNEL_KEYS:
            check(key, getattr(self, key))


@dataclass(frozen=True)
class StepCosts:
    """Coefficients for the steps of a plan, in microseconds on a core of speed 1.

    Attributes:
        table: a coefficient for each of ``NAMES``.
        window: messages through memory that processes share.
        message: MPI messages.
        network: MPI messages between hosts; None where that was not measured.
        cores: speed of each core; process p runs on core p, beyond the last one at speed 1.

    Raises:
        ValueError: a coefficient is missing, unknown, negative or not finite.
    """

    table: Mapping[str, float] = field(hash=False)
    window: ChannelCosts
    message: ChannelCosts
    cores: tuple[float, ...] = field(default=())
    network: ChannelCosts | None = None

    def __post_init__(self) -> None:
        if wrong := sorted(set(self.table).symmetric_difference(NAMES)):
            raise ValueError(f"{wrong[0]} is {'unknown' if wrong[0] in self.table else 'missing'}")
        for name, value in self.table.items():
            check(name, value)
        for speed in self.cores:
            if not (math.isfinite(speed) and 0.01 <= speed <= 100):
                raise ValueError("cores must be speeds from 0.01 to 100")

    def __getitem__(self, name: str) -> float:
        """Return a coefficient."""
        return self.table[name]

    @property
    def narrow(self) -> bool:
        """Whether no register holds the eight numbers that loops compute with."""
        return self["process.register"] < 64

    def total(self, counts: Mapping[str, float]) -> float:
        """Return the time of something by how often each coefficient counts, microseconds."""
        return sum(self.table[name] * count for name, count in counts.items())

    def joint(self, kind: str) -> float:
        """Return the least time of a joint, alone or in a run, microseconds."""
        sweeps = min(self[f"articulate.{kind}"], self[f"articulate_columns.{kind}"])
        return self[f"kinematics.{kind}"] + sweeps + self[f"accelerate.{kind}"]

    def carried(self, kind: str) -> float:
        """Return the least time of carrying unit wrenches across a joint of a run."""
        return min(self[f"propagate_run.{kind}"], self[f"propagate_along.{kind}"])

    def row(self, kind: str, count: int) -> float:
        """Return the time of two, three or four joints of a kind side by side, microseconds."""
        lanes = "two" if count == 2 else "four"
        groups = ("kinematics", "articulate", "accelerate")
        return sum(self[f"{group}_{lanes}.{kind}"] for group in groups)

    def channel(self, name: str) -> ChannelCosts:
        """Return the costs of a channel; ``auto`` is the window, as on one node."""
        return self.message if name == "message" else self.window

    def speed(self, process: int) -> float:
        """Return the speed of the core of a process."""
        return self.cores[process] if process < len(self.cores) else 1.0

    def speeds(self, processes: int) -> tuple[float, ...]:
        """Return the speeds of the cores of so many processes."""
        return tuple(map(self.speed, range(processes)))

    @cached_property
    def kinds(self) -> tuple[str, ...]:
        """The joint kinds that are priced."""
        return tuple(KINDS)


def block_rows(kind: str) -> float:
    """Return how much of a block with five constraints one across a joint is.

    Blocks count by the rows of Z in their products.

    Args:
        kind: name of the joint's kind, or ``PRESCRIBED``.
    """
    constraints = 6 if kind == PRESCRIBED else len(KINDS[kind].constrained)
    return (1 + constraints) / 6


def check(name: str, value: float) -> None:
    """Raise ValueError unless a coefficient is a time that can be added up, or a cache's size."""
    if not (math.isfinite(value) and 0 <= value <= _most(name)):
        raise ValueError(f"{name} must be a number from 0 to {_most(name):g}")


def _most(name: str) -> float:
    """The largest value of a coefficient."""
    return LIMIT_OF_SIZES if name.endswith(".cache") else LIMIT


def read_steps(source: Source, document: Mapping[str, object]) -> StepCosts | None:
    """Return the tables [steps.*], [channel.*] and the list cores of a profile, if there are any.

    Raises:
        InputError: a table or key is missing, unknown, of the wrong type or out of range.
    """
    if "steps" not in document:
        for key in ("channel", "cores"):
            if key in document:
                raise source.error(f"{key} without the tables [steps.*]", key)
        return None
    found: dict[str, float] = {}
    steps = _table(source, document, "steps", GROUPS)
    for group, keys in GROUPS.items():
        given = group if group in steps else LIKE.get(group, group)
        if given not in steps and all(f"{group}.{key}" in ASSUMED for key in keys):
            continue
        row = _table(source, steps, given, keys, "steps")
        found |= {
            f"{group}.{key}": _time(source, row, key, "steps", given)
            for key in keys
            if key in row or f"{group}.{key}" not in ASSUMED
        }
    found = {**ASSUMED, **found}
    channels = _table(source, document, "channel", (*CHANNELS, NETWORK))
    costs = {}
    for channel in (*CHANNELS, *([NETWORK] if NETWORK in channels else [])):
        row = _table(source, channels, channel, CHANNEL_KEYS, "channel")
        times = (_time(source, row, key, "channel", channel) for key in CHANNEL_KEYS)
        costs[channel] = ChannelCosts(*times)
    cores = _cores(source, document)
    return StepCosts(found, costs["window"], costs["message"], cores, costs.get(NETWORK))


def _cores(source: Source, document: Mapping[str, object]) -> tuple[float, ...]:
    cores = document.get("cores", [])
    if not isinstance(cores, list) or len(cores) > 4096:
        raise source.error("cores must be a list of speeds", "cores")
    for speed in cores:
        number = isinstance(speed, int | float) and not isinstance(speed, bool)
        if not number or not 0.01 <= speed <= 100:
            raise source.error(
                "cores must be a list of speeds from 0.01 to 100; 1 is the core that was measured",
                "cores",
            )
    return tuple(float(speed) for speed in cores)


def _table(
    source: Source, parent: Mapping[str, object], name: str, keys: Collection[str], *path: str
) -> Mapping[str, object]:
    table = parent.get(name)
    if not isinstance(table, dict):
        whole = ".".join((*path, name))
        raise source.error(f"the table [{whole}] is missing: it holds {', '.join(keys)}")
    source.known(table, keys, *path, name)
    return table


def _time(source: Source, table: Mapping[str, object], key: str, *path: str) -> float:
    value = source.number(table, key, *path)
    name = ".".join((*path, key))
    if not 0 <= value <= _most(name):  # nor is nan
        raise source.error(f"{name} must be a number from 0 to {_most(name):g}", *path, key)
    return value
