"""A cost profile as TOML."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import astuple

from adagen.schedule.costs import CHANNEL_KEYS, CHANNELS, GROUPS, NETWORK
from adagen.schedule.profile import CostProfile


def profile_text(profile: CostProfile, remark: str, digits: int = 8) -> str:
    """Return the text of a profile file.

    Args:
        profile: what to write.
        remark: one line or more for people, such as which machine it is.
        digits: decimal places of a microsecond.
    """
    return "\n".join(_lines(profile, remark, digits)) + "\n"


def _lines(profile: CostProfile, remark: str, digits: int) -> Iterator[str]:
    def value(x: float) -> str:
        return repr(round(float(x), digits) + 0.0)

    yield from (f"# {line}" for line in remark.splitlines())
    yield f'name = "{profile.name}"'
    if profile.steps is not None and profile.steps.cores:
        yield f"cores = [{', '.join(map(repr, profile.steps.cores))}]  # speed of each"
    yield "\n# Eq. (11): alpha k^2 + beta k + gamma n + delta, microseconds."
    yield "[join]"
    for key in ("alpha", "beta", "gamma", "delta"):
        yield f"{key} = {value(getattr(profile, key))}"
    if profile.steps is None:
        return
    yield "\n# What the steps of a plan take, microseconds (docs/reference/cost_profiles.md)."
    for group, keys in GROUPS.items():
        yield f"[steps.{group}]"
        yield from (f"{key} = {value(profile.steps[f'{group}.{key}'])}" for key in keys)
        yield ""
    costs = {channel: profile.steps.channel(channel) for channel in CHANNELS}
    if profile.steps.network is not None:
        costs[NETWORK] = profile.steps.network
    for k, (channel, times) in enumerate(costs.items()):
        yield f"\n[channel.{channel}]" if k else f"[channel.{channel}]"
        row = zip(CHANNEL_KEYS, astuple(times), strict=True)
        yield from (f"{key} = {value(x)}" for key, x in row)
