"""The paper's rule for one process (Section III-D), read literally."""

from __future__ import annotations

from adagen.paper.one_process import SingleProcess
from adagen.schedule.chains import Chain, Chains


def literal_rule(chains: Chains, chain: Chain) -> list[int]:
    """Return the order of assembly that the text of III-D gives for one process, read literally.

    For each joint the boundary joints on its root side and on its end side are counted, N^r and
    N^e. Joints with N^r <= N^e go to the lower layer, that is, they are assembled earlier; within a
    layer the end goes before the root. With one boundary joint or none the sentence on branches
    decides alone: the branch next to the boundary comes last.

    This is optimal for at most one boundary joint and *not* beyond: with parents
    (0, 1, 2, 1, 2, 4, 3, 5, 5, 7, 7), S = {6, 9} and boundary {2, 10} it costs 52.6 where 43.6 is
    possible (paper's constants). Schedules use SingleProcess.

    Args:
        chains: the robot.
        chain: the partial chain.

    Returns:
        Joints, the first one assembled first.
    """
    if chains.boundary(chain) <= 1:
        return SingleProcess(chains).order(chain)

    def layer(p: int) -> tuple[bool, int]:
        end_side = sum(p < cut < chains.end[p] for cut in chain.cuts)
        return chains.boundary(chain) - end_side > end_side, -p

    return [chains.original[p] for p in sorted(chains.positions(chain), key=layer)]
