"""Cost profiles: the constants of Eq. (11) and costs of steps, read and strictly checked.

Inside the scheduler a time is a whole number of picoseconds (*ticks*). Sums of ticks are exact, so
that two schedules are equally long or they are not: no tolerance decides a tie, and the answer is
the same on every machine.
"""

from __future__ import annotations

import math
import os
import re
from dataclasses import dataclass, replace
from functools import lru_cache
from importlib import resources
from pathlib import Path

from adagen.errors import InputError, UsageError
from adagen.schedule.costs import StepCosts, read_steps
from adagen.tomlfile import parse_toml

TICKS = 1_000_000
"""Ticks in a microsecond."""

Processor = tuple[str, int]
"""Maker and family, as x86 processors tell them."""
SHIPPED = ("default", "xeon", "zen4", "avx2", "paper")
"""Names of the profiles that come with adagen."""
NATIVE = "native"
"""Stands for the one of these that fits the machine."""

_LIMIT = 1e6  # microseconds; keeps every sum far below 2^63 ticks
_COEFFICIENTS = ("alpha", "beta", "gamma", "delta")


@dataclass(frozen=True)
class CostProfile:
    """Coefficients of Eq. (11), in microseconds.

    Attributes:
        name: what reports and emitted headers call it.
        alpha: per squared number k of boundary joints, for the k^2 inverse inertias; not negative.
        beta: per boundary joint, for the bias accelerations; not negative.
        gamma: per degree of freedom; usually negative.
        delta: of any join; ``delta + gamma n`` is positive for n = 1..6.
        steps: what the steps of a plan cost on a machine, where that was measured; the paper's
            profile prices joins alone.

    Raises:
        ValueError: a coefficient is not finite, too large or of the wrong sign.
    """

    name: str
    alpha: float
    beta: float
    gamma: float
    delta: float
    steps: StepCosts | None = None

    def __post_init__(self) -> None:
        for key in _COEFFICIENTS:
            value = getattr(self, key)
            if not math.isfinite(value) or abs(value) > _LIMIT:
                raise ValueError(f"{key} must be a finite number of microseconds up to {_LIMIT:g}")
        for key in ("alpha", "beta"):
            if getattr(self, key) < 0:
                raise ValueError(
                    f"{key} must not be negative: a join never gets cheaper with more joints around"
                )
        for dofs in (1, 6):
            if self.join(0, dofs) <= 0:
                raise ValueError(
                    f"delta + {dofs} gamma must be positive: the cost of a join with {dofs} "
                    "degrees of freedom"
                )

    @property
    def measured(self) -> StepCosts:
        """Costs of the steps of a plan.

        Raises:
            ValueError: the profile prices joins alone, as the paper's does.
        """
        if self.steps is None:
            raise ValueError(f"the profile {self.name} has no costs of steps")
        return self.steps

    def joins_only(self) -> CostProfile:
        """Return the same profile without costs of steps: Eq. (11) alone, for form `ada`."""
        return replace(self, steps=None)

    def boundary(self, k: int) -> int:
        """Return q(k) = alpha k^2 + beta k in ticks, the part that the schedule decides."""
        return _ticks(self.alpha) * k * k + _ticks(self.beta) * k

    def fixed(self, dofs: int) -> int:
        """Return gamma n + delta in ticks, which every schedule pays."""
        return _ticks(self.gamma) * dofs + _ticks(self.delta)

    def join(self, k: int, dofs: int) -> int:
        """Return Eq. (11) in ticks for k boundary joints and a joint of ``dofs`` freedoms."""
        return self.boundary(k) + self.fixed(dofs)


def _ticks(microseconds: float) -> int:
    return round(microseconds * TICKS)


def profiles_folder() -> Path:
    """Return where measured profiles are kept: ``adagen/profiles`` in XDG_CONFIG_HOME.

    That is ~/.config by default. The XDG specification has relative paths ignored.
    """
    base = os.environ.get("XDG_CONFIG_HOME", "")
    folder = Path(base) if base and Path(base).is_absolute() else Path("~/.config").expanduser()
    return folder / "adagen" / "profiles"


def stored_profiles() -> list[str]:
    """Return the names of the profiles measured on this machine, ascending."""
    try:
        return sorted(path.stem for path in profiles_folder().glob("*.toml") if path.is_file())
    except OSError:
        return []


def load_profile(name: str) -> CostProfile:
    """Return the shipped profile of that name, the one stored under it, or that of a TOML file.

    A shipped name always means the shipped profile: what is emitted under it must not depend on
    what has been measured here.

    Raises:
        UsageError: there is no such profile.
        InputError: the file cannot be read or is not a valid profile.
    """
    return parse_profile(*profile_text(name))


def profile_text(name: str) -> tuple[str, str]:
    """Return the text of the profile that ``load_profile`` reads, and its name in messages.

    Raises:
        UsageError: there is no such profile.
        InputError: the file cannot be read.
    """
    if name in SHIPPED:
        path = resources.files("adagen.schedule") / "profiles" / f"{name}.toml"
        return path.read_text("utf-8"), f"{name}.toml"
    own = profiles_folder() / f"{name}.toml" if name in stored_profiles() else Path(name)
    try:
        return own.read_bytes().decode("utf-8"), str(own)
    except FileNotFoundError:
        known = ", ".join(dict.fromkeys((*SHIPPED, NATIVE, *stored_profiles())))
        raise UsageError(
            f"no cost profile '{name}': give a TOML file or one of {known}; adagen calibrate "
            "measures this machine's"
        ) from None
    except UnicodeDecodeError:
        raise InputError("a cost profile must be UTF-8 text", name) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or "not a usable path"
        raise InputError(f"cannot read the cost profile: {reason}", name) from None


def shipped_for(register: int, processor: Processor | None = None) -> str:
    """Return the shipped profile that was measured on the processor that is the most alike.

    Args:
        register: bytes of the widest registers that solvers use.
        processor: the maker's name and the family of the processor, where they are known.
    """
    if register < load_profile("default").measured["process.register"]:
        return "avx2"
    match processor:
        case ("GenuineIntel", _):
            return "xeon"
        case ("AuthenticAMD", 25):  # Zen 3 and 4, of which Zen 4 has such registers
            return "zen4"
    return "default"


def with_steps(profile: CostProfile | None) -> CostProfile:
    """Return a profile; the shipped one where it prices joins alone, or none is given."""
    return _shipped() if profile is None or profile.steps is None else profile


def step_costs(profile: CostProfile | None) -> StepCosts:
    """Return the costs of steps of a profile, or of the shipped one if it has none."""
    return with_steps(profile).measured


@lru_cache(maxsize=1)
def _shipped() -> CostProfile:
    return load_profile("default")


@lru_cache(maxsize=16)  # a call of the tool asks for its profile several times
def parse_profile(text: str, file: str) -> CostProfile:
    """Return the profile written in TOML; ``file`` is its name in messages.

    Raises:
        InputError: not TOML, a key is missing, unknown or of the wrong type, or a value is out of
            range; the message names the line where it can.
    """
    source, document = parse_toml(text, file, "a cost profile")
    source.known(document, ("name", "join", "steps", "channel", "cores"))
    name = document.get("name")
    if not isinstance(name, str) or not re.fullmatch(r"[A-Za-z0-9._-]{1,64}", name):
        raise source.error(
            'give the profile a name: name = "..." of up to 64 letters, digits, dots and hyphens',
            "name",
        )
    join = document.get("join")
    if not isinstance(join, dict):
        raise source.error(
            f"give the constants of Eq. (11) in a table [join]: {', '.join(_COEFFICIENTS)}"
        )
    source.known(join, _COEFFICIENTS, "join")
    values = {key: source.number(join, key, "join") for key in _COEFFICIENTS}
    steps = read_steps(source, document)
    try:
        return CostProfile(name, **values, steps=steps)
    except ValueError as error:
        raise source.error(str(error), "join", str(error).split()[0]) from None
