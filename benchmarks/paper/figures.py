"""Table I and Figs. 3 and 5 to 9: schedule trees, search trees and what they cost."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import permutations
from math import comb, factorial

from rich.console import Console
from rich.table import Table

from adagen.paper.one_process import SingleProcess
from adagen.schedule import Node, Schedule, Topology, levels, load_profile, schedule_line
from adagen.schedule.chains import Chain, Chains
from adagen.schedule.profile import TICKS
from adagen.schedule.tree import Strategy
from adagen.schedule.tree_draft import Draft
from adagen.search import find_schedule
from adagen.search.named import as_schedule
from benchmarks.paper.literal_rule import literal_rule
from benchmarks.paper.pictures import Branch, branch, height, save_forest

PAPER = load_profile("paper")
FOUR = Topology.serial(4)


def ordered(topology: Topology, order: Sequence[int], processes: int) -> Schedule:
    """Return the schedule of an order of assembly, the first joint assembled first."""
    draft = Draft(len(topology))
    draft.root = draft.contract(topology, order)
    draft.assign(draft.root, (0, processes))
    return as_schedule(draft, topology, PAPER, "file")


def table_1() -> None:
    """The joints a, b, c, d of the optimal schedules of serial chains."""
    table = Table("N", "P=2: a", "us", "P=4: b", "c", "d", "us", "verdict")
    for joints in (16, 32, 64):
        topology = Topology.serial(joints)
        two, four = (find_schedule(topology, p, profile=PAPER, tie="lex") for p in (2, 4))
        b, c, d = (node.joint for node in list(levels(four.root))[:3])
        row = (joints, two.root.joint, two.makespan, b, c, d, four.makespan)
        table.add_row(*(f"{x:g}" for x in row), f"{two.verdict}, {four.verdict}")
    Console().print(table)


def figure_3() -> None:
    """Three schedule trees of the four-joint serial chain on two processes."""
    orders = {"a": (3, 2, 1, 0), "b": (1, 3, 2, 0), "c": (0, 1, 3, 2)}
    trees = []
    for name, order in orders.items():
        s = ordered(FOUR, order, 2)
        caption = f"({name}) height {height(s.root)}, {s.makespan:.1f} us"
        trees.append((caption, branch_by_branch(s.root)))
        print(f"{caption}: {schedule_line(s, FOUR)}")
    save_forest("fig3", "Fig. 3: schedule trees of the chain 0-1-2-3, two processes", trees)


def branch_by_branch(node: Node) -> Branch:
    """Return a schedule tree to draw, every node of it."""
    below = tuple(branch_by_branch(child) for child in node.children)
    return Branch(str(node.joint), node.processes[0], below)


def figure_5() -> None:
    """How many orders of assembly make one schedule tree."""
    table = Table("N", "orders N!", "schedule trees", "orders a tree, mean")
    for n in range(2, 11):
        count = comb(2 * n, n) // (n + 1)  # Catalan: serial chains
        table.add_row(str(n), str(factorial(n)), str(count), f"{factorial(n) / count:.1f}")
    seen: dict[str, list[tuple[int, ...]]] = {}
    for order in permutations(range(4)):
        seen.setdefault(schedule_line(ordered(FOUR, order, 2), FOUR), []).append(order)
    Console().print(table)
    same = [orders for orders in seen.values() if len(orders) > 1]
    print(f"N=4: {len(seen)} trees of 24 orders; {len(same)} trees come of more than one, such as")
    trees = []
    for name, sequence in (("a", (2, 1, 3, 0)), ("b", (2, 3, 1, 0))):
        s = ordered(FOUR, sequence[::-1], 2)
        print(f"({name}) searched in the order {sequence}: {schedule_line(s, FOUR)}")
        trees.append((f"({name}) {' '.join(map(str, sequence))}", branch_by_branch(s.root)))
    save_forest("fig5", "Fig. 5: two orders, one schedule tree", trees)


def search_tree(prefix: tuple[int, ...], *, improved: bool) -> Branch:
    """Return the search tree under a sequence of joints of the four-joint chain."""
    following = _slot(prefix) if improved else [j for j in range(4) if j not in prefix]
    below = tuple(search_tree((*prefix, j), improved=improved) for j in following)
    return Branch(str(prefix[-1]) if prefix else "S", -1, below)


def _slot(prefix: tuple[int, ...]) -> list[int]:
    """Return the joints of the first open slot, level by level, root side first (III-B-1)."""
    row: list[list[int]] = [[0, 1, 2, 3]]
    rest = list(prefix)
    while row:
        following = []
        for slot in row:
            if not rest:
                return slot
            cut = rest.pop(0)
            sides = [j for j in slot if j < cut], [j for j in slot if j > cut]
            following += [side for side in sides if side]
        row = following
    return []


def size(tree: Branch) -> int:
    """Return the number of nodes below the root of a tree."""
    return sum(1 + size(below) for below in tree.below)


def figure_6() -> None:
    """The search tree of the four-joint chain, and schedule trees of some of its paths."""
    tree = search_tree((), improved=True)
    paths = [(0, 1, 2, 3), (1, 0, 2, 3), (2, 0, 3, 1)]
    trees = [("search tree, improved NextNodes()", tree)]
    for path in paths:
        s = ordered(FOUR, path[::-1], 2)
        trees.append((f"S {' '.join(map(str, path))}", branch_by_branch(s.root)))
    save_forest("fig6", "Fig. 6: search tree and schedule trees of the chain 0-1-2-3", trees)
    print(f"{size(tree)} nodes; naive: {size(search_tree((), improved=False))}")


def figure_7() -> None:
    """The naive NextNodes() against the improved one."""
    naive, better = search_tree((1,), improved=False), search_tree((1,), improved=True)
    trees = [(f"naive, {size(naive)} nodes", naive), (f"improved, {size(better)} nodes", better)]
    save_forest("fig7", "Fig. 7: search tree under node 1", trees)
    table = Table("N", "naive", "improved", "improved, admissible estimate", "partial chains")
    runs: list[tuple[Strategy, bool]] = [("paper", False), ("paper", True), ("astar", True)]
    for joints in (4, 8, 12, 16, 32):
        topology = Topology.serial(joints)
        row = []
        for strategy, improved in [*runs, ("exact", True)]:
            s = find_schedule(
                topology, 4, profile=PAPER, strategy=strategy, improved=improved, expansions=10_000
            )
            row.append(str(s.expanded) if s.expanded <= 10_000 else "> 10000")
        table.add_row(str(joints), *row)
    print("nodes expanded for P=4 (III-D fills chains on one process at once)")
    Console().print(table)


def figure_8() -> None:
    """Orders of least work for one process, and where the literal rule of III-D fails."""
    trees = []
    for name, end in (("1", 2), ("2", 4)):
        topology = Topology.bare((0, 1, 2, 1, 4, end + 1))  # joint 5 is outside the chain
        order = SingleProcess(Chains(topology, PAPER)).order(_without(topology, 5))
        draft = Draft(len(topology))
        root = draft.contract(topology, order)
        trees.append((f"({name}) boundary joint on joint {end}", _drawn(draft, root)))
        print(f"boundary at joint {end}: assembled in the order {order}")
    save_forest("fig8", "Fig. 8: joints 0-4, branches 1-2 and 3-4; one process", trees)
    _counterexample()


def _without(topology: Topology, joint: int) -> Chain:
    """Return the chain of everything above a leaf joint."""
    chains = Chains(topology, PAPER)
    return Chain(0, (chains.original.index(joint),))


def _drawn(draft: Draft, joint: int) -> Branch:
    below = tuple(_drawn(draft, child) for child in draft.children(joint) if child >= 0)
    return Branch(str(joint), 0, below)


def _counterexample() -> None:
    topology = Topology.bare((0, 1, 2, 1, 2, 4, 3, 5, 5, 7, 7))
    chains = Chains(topology, PAPER)
    single = SingleProcess(chains)
    chain = Chain(3, (chains.original.index(10),))
    joints = sorted(chains.original[p] for p in chains.positions(chain))
    literal, exact = literal_rule(chains, chain), single.order(chain)
    costs = [_cost(chains, order) for order in (literal, exact)]
    print(f"III-D read literally, joints {joints} with two boundary joints:")
    print(f"  literal {literal}: {costs[0]:.1f} us; exact {exact}: {costs[1]:.1f} us")


def _cost(chains: Chains, order: Sequence[int]) -> float:
    """Return the work of an order of a chain, by Eq. (11)."""
    total, topology = 0, chains.topology
    groups = {link: {link} for link in range(len(topology) + 1)}
    for joint in order:
        above, below = groups[topology.parents[joint]], groups[joint + 1]
        merged = above | below
        for link in merged:
            groups[link] = merged
        touching = sum(
            (topology.parents[j] in merged) != (j + 1 in merged) for j in range(len(topology))
        )
        total += chains.profile.join(touching, topology.dofs[joint])
    return total / TICKS


def figure_9() -> None:
    """Optimal schedules of the 16-joint chain on two and four processes."""
    trees = []
    for p in (2, 4):
        s = find_schedule(Topology.serial(16), p, profile=PAPER, tie="lex")
        trees.append((f"({p // 2}) {p} processes, {s.makespan:.1f} us", branch(s.root)))
        print(f"P={p}: {schedule_line(s, Topology.serial(16))}")
    save_forest("fig9", "Fig. 9: optimal schedules of a 16-joint chain", trees)
