"""The tree that links and joints form, or the reason why they form none."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from adagen.union_find import UnionFind
from adagen.urdf.description import Description, JointElement
from adagen.urdf.notes import Notes, quoted


@dataclass(frozen=True)
class Tree:
    """The tree that links and joints form, and the joints that close loops of it.

    Attributes:
        root: name of the link that no joint of the tree holds.
        below: joints of the tree by the name of their parent link, in the order of their names.
        above: the joint of the tree that holds each link but the root.
        closing: all other joints, in file order.
    """

    root: str
    below: dict[str, tuple[JointElement, ...]]
    above: dict[str, JointElement]
    closing: tuple[JointElement, ...]

    def depth_first(self) -> list[JointElement]:
        """Return all joints, parents before children, siblings by name."""
        order: list[JointElement] = []
        stack = list(reversed(self.below.get(self.root, ())))
        while stack:
            joint = stack.pop()
            order.append(joint)
            stack.extend(reversed(self.below.get(joint.child, ())))
        return order


def make_tree(description: Description, notes: Notes) -> Tree:
    """Return the tree of a description.

    Joints join the tree in file order: one that comes to a link which has a parent joint, or which
    it hangs on itself, closes a loop.

    Raises:
        InputError: a joint names a link that does not exist, links hang on each other alone, or
            there are several roots.
    """
    above: dict[str, JointElement] = {}
    below: dict[str, list[JointElement]] = {}
    closing = []
    tops = UnionFind[str]()
    for joint in description.joints:
        _check_ends(joint, description, notes)
        if joint.child in above or tops.of(joint.parent) == joint.child:
            closing.append(joint)
            continue
        above[joint.child] = joint
        tops.join(joint.child, joint.parent)
        below.setdefault(joint.parent, []).append(joint)
    root = _root(description, above, closing, notes)
    return Tree(
        root,
        {link: tuple(sorted(joints, key=lambda j: j.name)) for link, joints in below.items()},
        above,
        tuple(closing),
    )


def _check_ends(joint: JointElement, description: Description, notes: Notes) -> None:
    for role, link in (("parent", joint.parent), ("child", joint.child)):
        if link not in description.link_names:
            raise notes.error(
                f'joint "{joint.name}": {role} link "{link}" is not declared: '
                f"add a <link> with this name or correct the name",
                joint.line,
            )
    if joint.parent == joint.child:
        raise notes.error(
            f'joint "{joint.name}" joins link "{joint.child}" to itself: correct parent or child',
            joint.line,
        )


def _root(
    description: Description,
    above: dict[str, JointElement],
    closing: Sequence[JointElement],
    notes: Notes,
) -> str:
    roots = [link for link in description.links if link.name not in above]
    # No link hangs on itself, so that there is at least one.
    if len(roots) == 1:
        return roots[0].name
    for joint in closing:
        if joint.child not in above:
            raise _detached(joint, above, notes)
    parents = {joint.parent for joint in description.joints}
    alone = [link for link in roots if link.name not in parents]
    culprit = alone[0] if alone else roots[1]
    raise notes.error(
        f"{len(roots)} links are no joint's child, {quoted([r.name for r in roots])}, and a "
        f'tree has one root: join link "{culprit.name}" to the robot or remove it',
        culprit.line,
    )


def _detached(joint: JointElement, above: dict[str, JointElement], notes: Notes) -> Exception:
    """Return the refusal of a ring that does not hang on the root."""
    ring = [joint.parent]
    while ring[-1] != joint.child:
        ring.append(above[ring[-1]].parent)
    return notes.error(
        f'links {quoted(sorted(ring))} form a loop through joint "{joint.name}" and hang on '
        "nothing else: let the first joint in the file that has one of them as its child join it "
        "to the robot",
        joint.line,
    )
