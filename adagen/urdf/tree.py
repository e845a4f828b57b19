"""The tree that links and joints form, or why they form none."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from adagen.urdf.description import Description, JointElement
from adagen.urdf.elements import Element
from adagen.urdf.notes import Notes, line_of, quoted

_CLOSED: Mapping[str, str] = {
    "loop": "closed loops are not modelled; remove it to solve the open chain",
    "loop_joint": "closed loops are not modelled; remove it to solve the open chain",
    "coupling": "couplings are not modelled; write it as a <mimic> of a joint and say --mimic, "
    "or remove it to leave the joints free",
}
"""Elements of <robot> that hold an open chain's joints together (URDF+, Drake), and what to do."""


@dataclass(frozen=True)
class Tree:
    """An open chain.

    Attributes:
        root: name of the link that is no joint's child.
        below: joints by the name of their parent link, in the order of their names.
    """

    root: str
    below: dict[str, tuple[JointElement, ...]]

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

    Raises:
        InputError: a joint names a link that does not exist, a link has two parents, joints form a
            loop, or there are several roots.
    """
    parent_joint: dict[str, JointElement] = {}
    below: dict[str, list[JointElement]] = {}
    for joint in description.joints:
        _check_ends(joint, description, notes)
        other = parent_joint.get(joint.child)
        if other is not None:
            raise notes.error(
                f'link "{joint.child}" has two parent joints, "{other.name}" and "{joint.name}": '
                "closed loops are not supported, remove one",
                joint.line,
            )
        parent_joint[joint.child] = joint
        below.setdefault(joint.parent, []).append(joint)
    root = _root(description, parent_joint, notes)
    return Tree(
        root,
        {link: tuple(sorted(joints, key=lambda j: j.name)) for link, joints in below.items()},
    )


def refuse_closed(root: Element, notes: Notes) -> None:
    """Refuse elements that close the tree: without them the robot would be another machine.

    Args:
        root: the element <robot>.
        notes: makes the refusal.

    Raises:
        InputError: there is a loop or a coupling; the message names all of its kind.
    """
    found: dict[str, list[Element]] = {}
    for element in root:
        name = str(element.tag).rpartition("}")[2].lower()
        if name in _CLOSED:
            found.setdefault(name, []).append(element)
    for name, elements in found.items():
        names = quoted([element.get("name", "") for element in elements])
        raise notes.error(f"<{name}> {names}: {_CLOSED[name]}", line_of(elements[0]))


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


def _root(description: Description, parent_joint: dict[str, JointElement], notes: Notes) -> str:
    _refuse_loops(description, parent_joint, notes)
    roots = [link for link in description.links if link.name not in parent_joint]
    # Without loops every link leads to a root, so that there is at least one.
    if len(roots) > 1:
        parents = {joint.parent for joint in description.joints}
        alone = [link for link in roots if link.name not in parents]
        culprit = alone[0] if alone else roots[1]
        raise notes.error(
            f"{len(roots)} links are no joint's child, {quoted([r.name for r in roots])}, and a "
            f'tree has one root: join link "{culprit.name}" to the robot or remove it',
            culprit.line,
        )
    return roots[0].name


def _refuse_loops(
    description: Description, parent_joint: dict[str, JointElement], notes: Notes
) -> None:
    leads_to_root: set[str] = set()
    for link in description.links:
        path: list[str] = []
        on_path: set[str] = set()
        name = link.name
        while name in parent_joint and name not in leads_to_root:
            if name in on_path:
                loop = path[path.index(name) :]
                joint = parent_joint[name]
                raise notes.error(
                    f"links {quoted(sorted(loop))} form a loop through joint "
                    f'"{joint.name}": closed loops are not supported, remove a joint',
                    joint.line,
                )
            path.append(name)
            on_path.add(name)
            name = parent_joint[name].parent
        leads_to_root.update(path)
