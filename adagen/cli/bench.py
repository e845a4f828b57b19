"""``adagen bench``: emitted solvers beside other libraries, on the user's own robots."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from adagen.cli.console import long_note
from adagen.cli.options import profile
from adagen.cli.parser import Parser, among, listed, make_parser, parse, whole
from adagen.cli.scale import add_scale, check_scale, give, run_scale
from adagen.cli.tables import table_of

if TYPE_CHECKING:
    from adagen.studies.bench.record import Record

PEERS = ("pinocchio", "casadi", "mujoco")
QUICK = ("--procs 1", "--procs 2")

_DESCRIPTION = """\
Compare emitted solvers of each MODEL with the forward dynamics of pinocchio,
casadi and MuJoCo: same robot, same states, times measured in turns, errors of
all answers checked."""

_EPILOG = """\
Peers that are not installed are skipped by name; pip install 'adagen[bench]'
installs them all. Pinocchio is compiled against its headers, a minute for each
compiler the first time.

examples:
  adagen bench arm.urdf                                 a table
  adagen bench humanoid.urdf --floating --out result    tables, record, pictures
  adagen bench fourbar.urdf --scene fourbar.toml        with closed loops
  adagen bench arm.urdf --variant "--procs 2 --form ada" --peers none
  adagen bench --scale --out result                     chains, processes, hosts"""


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen bench`` with the arguments after the verb; return the exit status."""
    parser = command_parser()
    options = parse(parser, argv)
    check_scale(parser, options)
    if options.scale:
        return run_scale(options)
    from adagen.cli.contest import Entry, contest
    from adagen.studies.bench.contest import Rules
    from adagen.studies.bench.report import markdown
    from adagen.studies.bench.variants import VARIANTS

    rules = Rules(rounds=3, repeat=5) if options.quick else Rules(options.rounds)
    variants = tuple(options.variant or (QUICK if options.quick else VARIANTS))
    extra = ["--profile", options.profile, *(["--floating"] if options.floating else [])]
    extra += [] if options.scene is None else ["--scene", options.scene]
    entries = [Entry(Path(path).stem, Path(path), tuple(extra)) for path in options.models]
    peers = PEERS if options.peers is None else options.peers
    record = contest(entries, rules, variants, peers)
    give(record, options, _show, "bench", markdown)
    return 0


def command_parser() -> Parser:
    """Return the parser of ``adagen bench``."""
    parser = make_parser("adagen bench", _DESCRIPTION, _EPILOG)
    parser.usage = "adagen bench MODEL ... [option ...]"
    parser.add_argument(
        "models", nargs="*", default=(), metavar="MODEL", help="robot descriptions (URDF)"
    )
    add_scale(parser)
    parser.add_argument("--floating", action="store_true", help="put the robots on floating bases")
    parser.add_argument("--scene", metavar="FILE", help="scene of the robots: loops, base, ...")
    parser.add_argument(
        "--profile",
        type=profile,
        default="default",
        metavar="NAME|FILE",
        help="cost profile: a name or a TOML file (default: default)",
    )
    parser.add_argument(
        "--variant",
        action="append",
        metavar="WORDS",
        help="what to emit, as options of adagen MODEL, such as --variant='--procs 1 --refine 1'; "
        "may be given several times (default: one, two and four processes, float, and every code "
        "shape); with more processes than cores, times are from measured stretches of computing",
    )
    parser.add_argument(
        "--peers",
        type=_peers,
        metavar="NAMES",
        help=f"comma-separated peers, of {', '.join(PEERS)}, or none (default: all)",
    )
    parser.add_argument(
        "--rounds",
        type=whole(1, 1000),
        default=9,
        metavar="N",
        help="rounds of interleaved timing (default: 9)",
    )
    parser.add_argument("--quick", action="store_true", help="few rounds and variants")
    parser.add_argument("--json", action="store_true", help="print the record as JSON")
    parser.add_argument(
        "--out", type=Path, metavar="DIR", help="write record, tables and pictures there"
    )
    return parser


def _peers(text: str) -> tuple[str, ...]:
    return () if text == "none" else listed(among(PEERS))(text)


_HEADS = ("solver", "median", "least", "× pin.", "predicted", "error", "residual")
"""Those of ``details``, in few letters."""


def _show(record: Record) -> None:
    """Print each robot's table."""
    from rich.console import Console

    from adagen.studies.bench.report import details

    console = Console()
    for model in record.models:
        title = f"{model.name}, {model.dofs} degrees of freedom; ns an evaluation"
        console.print(table_of(_HEADS, details(model), title=title, whole=True))
        for name, reason in model.absent.items():
            long_note(f"{model.name}: without {name}: {reason}")
