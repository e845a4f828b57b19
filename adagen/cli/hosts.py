"""``adagen schedule --hosts FILE``: predicted times on several hosts."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import TYPE_CHECKING

from adagen.cli.tables import table_of, wrapped
from adagen.errors import UsageError

if TYPE_CHECKING:
    import argparse

    from adagen.model import Model
    from adagen.search.several_hosts import Across


def show_hosts(model: Model, options: argparse.Namespace) -> None:
    """Print what is predicted of a robot on the hosts of a file: for people, or as JSON.

    Raises:
        InputError: the file of hosts, or the profile, is refused.
        UsageError: the profile does not tell what messages between hosts cost.
    """
    from adagen.schedule import load_profile, read_fabric, read_hosts
    from adagen.search.several_hosts import across_hosts

    profile = load_profile(options.profile)
    if options.hosts.suffix == ".toml":
        fabric = read_fabric(options.hosts)
        hosts, network = fabric.hosts, fabric.network
    else:
        hosts, network = read_hosts(options.hosts), None
    if profile.steps is None or (network is None and profile.steps.network is None):
        raise UsageError(
            f"the profile {profile.name} has no costs of messages between hosts: run adagen "
            f"calibrate --hosts {options.hosts}, then add --profile machine"
        )
    found = across_hosts(model, hosts, profile, network)
    if options.json:
        print(json.dumps(_document(found), indent=1))
    else:
        _show(found)


def _document(found: Across) -> dict[str, object]:
    pays = found.best_shared
    return {
        "profile": found.profile,
        "single": {
            "hosts": 1 if pays is None else pays.hosts,
            "one_host": {"processes": found.alone.processes, "us": found.alone.time},
            "several": [asdict(one) for one in found.shared],
        },
        "batch": {
            "hosts": found.best_batches.hosts,
            "state_us": found.state,
            "several": [
                {
                    "hosts": one.hosts,
                    "processes": one.processes,
                    "states_per_second": 1e6 * one.rate,
                    "in_place": 1e6 * one.in_place,
                    "limit": one.handout.limit,
                }
                for one in found.batches
            ],
        },
    }


def _show(found: Across) -> None:
    from rich.console import Console

    from adagen.search.several_hosts import STATES

    console = Console()
    print(wrapped(_single(found)))
    rows = (
        (
            str(one.hosts),
            str(one.processes),
            f"{1e6 * one.rate:.3g}",
            f"{1e6 * one.in_place:.3g}",
            one.handout.limit,
        )
        for one in found.batches
    )
    heads = ("hosts", "processes", "distributed, states/s", "in place, states/s", "limited by")
    console.print(table_of(heads, rows, named=False))
    best = found.best_batches
    print(
        wrapped(
            f"batches of {STATES} states distributed by process 0: "
            f"{best.hosts} host{'s' if best.hosts > 1 else ''} "
            f"pay{'' if best.hosts > 1 else 's'} ({found.state:.3g} us a state on one process); "
            "where each process has its own states, nothing is sent and all hosts pay "
            f"({found.profile} profile)"
        )
    )


def _single(found: Across) -> str:
    """Return in a few words where one evaluation is best."""
    one = found.alone
    processes = f"{one.processes} process{'es' if one.processes > 1 else ''}"
    here = f"{one.time:.2f} us on {processes} of one host"
    pays = found.best_shared
    if pays is not None:
        return (
            f"one evaluation: {pays.time:.2f} us on {pays.processes} processes of {pays.hosts} "
            f"hosts, {here}: hosts pay"
        )
    meeting = [each for each in found.shared if each.working > 1]
    if not meeting:
        return f"one evaluation: {here}; too short for messages between hosts: use one host"
    best = min(meeting, key=lambda each: each.time)
    return f"one evaluation: {here}, {best.time:.2f} us on {best.hosts} hosts: use one host"
