"""Cores where processes may gather, and their limbs, which the search assigns.

In a tree of moving links that several processes share, a *core* is chosen: a root link and joints
that hang together below it. What is left are limbs, each the work of one process: subtrees that
hang on links of the core, and all on the ground's side of its root. Links are numbered outwards, so
the root is the topmost link of the core; seen from any other link of it the core is the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, groupby

from adagen.model.paths import joints_on_links, last_beyond
from adagen.plan.edges import Edge, edges_from, is_base, joints_at
from adagen.plan.gather_trees import Tree, held_links, moving_trees
from adagen.plan.robot import PlanJoint
from adagen.program.runs import Run, runs
from adagen.program.strips import KINDS, fits_strips

_KEPT = 64  # roots whose edges are kept
_COMPARED = 256
"""Joints of a limb up to which it is compared with others."""


@dataclass(frozen=True)
class Core:
    """Where the processes of a tree meet.

    Attributes:
        tree: number of the tree.
        root: the topmost link.
        joints: outwards from it, ascending.
    """

    tree: int
    root: int
    joints: tuple[int, ...] = ()


@dataclass(frozen=True)
class Limb:
    """A subtree that one process computes as a whole.

    Attributes:
        tree: number of its tree.
        link: the link of the core that it hangs on; 0 for a tree that is not shared.
        spans: its joints, as ranges, ascending.
        up: whether it is what lies on the ground's side of a core.
        kind: equal for limbs that cost the same wherever they stand in a sequence.
    """

    tree: int
    link: int
    spans: tuple[range, ...]
    up: bool
    kind: object

    def __hash__(self) -> int:
        """Return a hash that is soon computed: bounds are kept by limbs."""
        return hash((self.link, self.first, self.up))

    @cached_property
    def first(self) -> int:
        """Its first joint."""
        return self.spans[0][0]

    @property
    def joints(self) -> Iterator[int]:
        """Its joints, ascending."""
        return chain.from_iterable(self.spans)

    def __len__(self) -> int:
        """Return how many joints it has."""
        return sum(map(len, self.spans))


class Robot:
    """A robot as trees of links that move together.

    Args:
        joints: its joints.

    Attributes:
        trees: its trees, not laid out.
        tree_of: the number of each joint's tree; length N.
        last: the last joint of the subtree that hangs on each joint; length N.
        at: the joints that hang on each link; length N + 1.
        held: for each link the one before it whose mobility is treated as a body; 0 for none.
        runs: what is passed in one go outwards, if nothing parts it.
        long: parts of them that may be passed in strips.
        prolonging: joints that go on with a run which may be passed in strips.
    """

    def __init__(self, joints: Sequence[PlanJoint]) -> None:
        self.joints = joints
        self.trees = moving_trees(joints)
        self.tree_of = [0] * len(joints)
        for number, tree in enumerate(self.trees):
            for link in tree.links:
                self.tree_of[link - 1] = number
        self.last, self.at = last_beyond(joints), joints_on_links(joints)
        self.held = held_links(joints)
        self.runs = runs(joints, (j for j, joint in enumerate(joints) if not is_base(joint)))
        self.long = [part for run in self.runs for part in self._long(run)]
        self.prolonging = {j for run in self.long for j in range(run.first + 1, run.last + 1)}
        self._kinds: dict[object, int] = {}
        self._kind_of: dict[int, object] = {}
        self._edges: dict[tuple[int, int], list[Edge]] = {}
        # Each is made once: by the link beyond it, its first joint, its tree.
        self._up: dict[int, Limb] = {}
        self._out: dict[int, Limb] = {}
        self._all: dict[int, Limb] = {}

    def _long(self, run: Run) -> Iterator[Run]:
        """The longest parts of a run that can be in strips."""
        own = range(run.first, run.last + 1)
        for fit, group in groupby(own, lambda j: self.joints[j].kind in KINDS):
            part = list(group)
            if fit and fits_strips(self.joints, Run(part[0], part[-1]), "double"):
                yield Run(part[0], part[-1])

    def floats(self, tree: int, link: int) -> bool:
        """Return whether a link floats on the ground."""
        base = self.trees[tree].base
        return base is not None and link == base + 1

    def limbs(self, cores: Sequence[Core]) -> tuple[Limb, ...]:
        """Return the limbs of cores, and the trees that are not shared, by their first joints."""
        shared = {core.tree for core in cores}
        found = [self._whole(t) for t in range(len(self.trees)) if t not in shared]
        for core in cores:
            found += self._around(core)
        return tuple(sorted(found, key=lambda limb: limb.first))

    def _around(self, core: Core) -> Iterator[Limb]:
        if not self.floats(core.tree, core.root):
            yield self._upwards(core.root)
        inside = set(core.joints)
        for link in (core.root, *(j + 1 for j in core.joints)):
            for j in self.at[link]:
                if j not in inside:
                    yield self._outwards(j)

    def _upwards(self, root: int) -> Limb:
        """All on the ground's side of a link."""
        if root not in self._up:
            tree, above = self.tree_of[root - 1], root - 1
            links = self.trees[tree].links
            first, last = links[0] - 1, links[-1] - 1
            spans = (range(first, above + 1), range(self.last[above] + 1, last + 1))
            whole = tuple(span for span in spans if span)
            self._up[root] = Limb(tree, root, whole, True, ("up", root))
        return self._up[root]

    def _outwards(self, joint: int) -> Limb:
        """A joint and all beyond it."""
        if joint not in self._out:
            tree, link = self.tree_of[joint], self.joints[joint].parent
            span = range(joint, self.last[joint] + 1)
            self._out[joint] = Limb(tree, link, (span,), False, (link, self.kind(joint)))
        return self._out[joint]

    def _whole(self, tree: int) -> Limb:
        if tree not in self._all:
            links = self.trees[tree].links
            span = range(links[0] - 1, links[-1])
            self._all[tree] = Limb(tree, 0, (span,), False, (0, self.kind(links[0] - 1)))
        return self._all[tree]

    def kind(self, joint: int) -> object:
        """Return what is equal for subtrees of joints that cost the same, and the same topology."""
        if joint not in self._kind_of:
            span = range(joint, self.last[joint] + 1)
            if len(span) > _COMPARED or joint in self.prolonging:
                return ("own", joint)
            features = tuple(
                (j - own.parent if j > joint else 0, own.kind, own.prescribed, own.tangents)
                for j, own in zip(span, self.joints[span.start : span.stop], strict=True)
            )
            self._kind_of[joint] = self._kinds.setdefault(features, len(self._kinds))
        return self._kind_of[joint]

    def unbranched(self, joint: int) -> tuple[int, ...]:
        """Return the joints from one on up to where limbs part next; none if they never do.

        A core that has one of them has them all: processes meet where limbs part.
        """
        found = [joint]
        while len(self.at[found[-1] + 1]) == 1:
            found += self.at[found[-1] + 1]
        return tuple(found) if self.at[found[-1] + 1] else ()

    def laid_out(self, core: Core, owner: dict[int, int], core_owner: int) -> Tree:
        """Return a shared tree with a layout.

        Args:
            core: where its processes meet.
            owner: the process of each joint that is not in the core; joints of other trees too.
            core_owner: the process that adds what belongs to the core.
        """
        tree = self.trees[core.tree]
        inside = frozenset(core.joints)
        own = {j: owner[j] for j in tree.joints if j not in inside}
        grounded = own[core.root - 1] if tree.base is None else None
        hold = 0 if grounded is None else self.held[core.root]
        edges = self._edges_from(core.tree, core.root)
        return Tree(
            *(tree.links, tree.joints, tree.base, core.root, edges, own, inside),
            *(core_owner, grounded, hold),
        )

    def alone(self, tree: int, process: int) -> Tree:
        """Return a tree that is all one process's."""
        own = self.trees[tree]
        edges = self._edges_from(tree, own.own_root)
        owner = dict.fromkeys(own.joints, process)
        return Tree(
            own.links, own.joints, own.base, own.own_root, edges, owner, frozenset(), process, None
        )

    def _edges_from(self, tree: int, root: int) -> list[Edge]:
        if (tree, root) not in self._edges:
            if len(self._edges) == _KEPT:
                self._edges.clear()
            at = self._joints_at[tree]
            self._edges[tree, root] = edges_from(root, self.joints, at)
        return self._edges[tree, root]

    @cached_property
    def _joints_at(self) -> list[dict[int, list[int]]]:
        return [joints_at(self.joints, tree.joints) for tree in self.trees]
