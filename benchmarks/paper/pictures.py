"""Trees and charts as SVG, drawn with what draws adagen's own schedules."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from adagen.drawing.svg import INK, MUTED, RULE, Canvas, colour
from adagen.schedule import Node, preorder

FOLDER = Path(__file__).resolve().parents[2] / "docs" / "records" / "pictures"
STEP, LAYER, RADIUS = 34.0, 46.0, 12.0


@dataclass(frozen=True)
class Line:
    """A line of a chart."""

    name: str
    points: Sequence[tuple[float, float]]
    dashed: bool = False


@dataclass(frozen=True)
class Branch:
    """A node of a tree to draw: its text, its process (-1: none) and what hangs from it."""

    text: str
    process: int
    below: tuple[Branch, ...] = ()
    note: str = ""


def save_forest(name: str, title: str, trees: Sequence[tuple[str, Branch]]) -> None:
    """Write a picture of trees, each with its caption, and the record behind it."""
    shown = [{"caption": caption} | asdict(tree) for caption, tree in trees]
    _save(name, forest(title, trees), {"title": title, "trees": shown})


def save_chart(name: str, title: str, lines: Sequence[Line]) -> None:
    """Write a picture of lines, and the record behind it."""
    _save(name, chart(title, lines), {"title": title, "lines": [asdict(line) for line in lines]})


def _save(name: str, picture: str, record: dict[str, object]) -> None:
    FOLDER.mkdir(parents=True, exist_ok=True)
    (FOLDER / f"{name}.svg").write_text(picture, encoding="utf-8")
    command = f"python -m benchmarks.paper {name.removesuffix('_measured').replace('_', '-')}"
    text = json.dumps({"command": command} | record, allow_nan=False) + "\n"
    (FOLDER / f"{name}.json").write_text(text, encoding="utf-8")
    print(f"wrote docs/records/pictures/{name}.svg and the record behind it, {name}.json")


def branch(node: Node) -> Branch:
    """Return a schedule tree to draw; a run of single descendants becomes one node."""
    run = [node]
    while len(run[-1].children) == 1 and run[-1].children[0].processes == node.processes:
        run.append(run[-1].children[0])
    joints = [n.joint for n in run]
    text = str(joints[0])
    if len(joints) > 2:
        text = f"{joints[0]} ... {joints[-1]}"
    elif len(joints) > 1:
        run = run[:1]
    a, b = node.processes
    note = "" if b - a == 1 else f"{a}-{b - 1}"
    return Branch(text, a, tuple(branch(child) for child in run[-1].children), note)


def forest(title: str, trees: Sequence[tuple[str, Branch]]) -> str:
    """Return trees side by side, each with a caption."""
    canvas = Canvas()
    canvas.text(20, 28, title, 15, bold=True)
    left, deepest = 20.0, 0.0
    for caption, tree in trees:
        width, depth = _tree(canvas, tree, left, 78)
        canvas.text(left, 52, caption, 11, fill=MUTED)
        left += max(width, 6.2 * len(caption)) + 36
        deepest = max(deepest, depth)
    return canvas.document(max(left, 9.0 * len(title)), deepest + 40, title)


def _tree(canvas: Canvas, tree: Branch, left: float, top: float) -> tuple[float, float]:
    """Draw a tree; return its width and the height of its lowest node."""
    place: dict[int, tuple[float, float]] = {}
    widest, lowest = 0.0, top

    def settle(node: Branch, x: float, y: float) -> float:
        """Place a tree whose left edge is x; return its right edge."""
        nonlocal widest, lowest
        lowest = max(lowest, y)
        right = x
        for below in node.below:
            right = settle(below, right, y + LAYER)
        own = x + max(STEP, 7.0 * len(node.text) + 14)
        right = max(right, own)
        if node.below:
            first, last = place[id(node.below[0])][0], place[id(node.below[-1])][0]
            place[id(node)] = ((first + last) / 2, y)
        else:
            place[id(node)] = ((x + right) / 2, y)
        widest = max(widest, right)
        return right

    settle(tree, left, top)
    stack = [tree]
    while stack:
        node = stack.pop()
        x, y = place[id(node)]
        for below in node.below:
            canvas.path([(x, y), place[id(below)]], RULE)
        stack += node.below
    _nodes(canvas, tree, place)
    return widest - left, lowest


def _nodes(canvas: Canvas, tree: Branch, place: dict[int, tuple[float, float]]) -> None:
    stack = [tree]
    while stack:
        node = stack.pop()
        x, y = place[id(node)]
        fill, ink = colour(node.process) if node.process >= 0 else ("#e4e4e4", INK)
        if len(node.text) > 2:
            half = 3.4 * len(node.text) + 6
            canvas.rect(x - half, y - RADIUS, 2 * half, 2 * RADIUS, fill)
        else:
            canvas.circle(x, y, RADIUS, fill)
        canvas.text(x, y + 4, node.text, 11, fill=ink, anchor="middle")
        if node.note:
            canvas.text(x + RADIUS + 4, y - 6, node.note, 9, fill=MUTED)
        stack += node.below


def chart(title: str, lines: Sequence[Line]) -> str:
    """Return a chart of times (us, from 0) against the index of the root."""
    canvas = Canvas()
    left, top, width, height = 64.0, 50.0, 620.0, 300.0
    most_x = max(x for line in lines for x, _ in line.points)
    most_y = 1.08 * max(y for line in lines for _, y in line.points)
    sx: Callable[[float], float] = lambda x: left + width * x / most_x  # noqa: E731
    sy: Callable[[float], float] = lambda y: top + height * (1 - y / most_y)  # noqa: E731
    canvas.text(20, 26, title, 14, bold=True)
    canvas.path([(left, top), (left, top + height), (left + width, top + height)], INK)
    for step in range(0, int(most_x) + 1, 25):
        canvas.text(sx(step), top + height + 16, str(step), 10, fill=MUTED, anchor="middle")
    tick = next(t for t in (5, 10, 20, 50, 100, 200, 500, 1000, 2000) if most_y / t <= 10)
    for i in range(int(most_y / tick) + 1):
        canvas.path([(left, sy(i * tick)), (left + width, sy(i * tick))], "#eeeeee")
        canvas.text(left - 6, sy(i * tick) + 3, str(i * tick), 10, fill=MUTED, anchor="end")
    canvas.text(left + width / 2, top + height + 34, "index of the root", 11, anchor="middle")
    canvas.text(20, top - 6, "us", 11)
    for i, line in enumerate(lines):
        ink = colour((0, 5, 0, 5)[i] if len(lines) > 2 and line.dashed else (0, 5)[i % 2])[0]
        points = [(sx(x), sy(y)) for x, y in line.points]
        canvas.path(points, ink, dashed=line.dashed)
        if not line.dashed and len(points) < 40:
            for x, y in points:
                canvas.circle(x, y, 3, ink)
        y = top + height + 54 + 16 * i
        canvas.path([(left, y - 4), (left + 28, y - 4)], ink, dashed=line.dashed)
        canvas.text(left + 36, y, line.name, 11)
    return canvas.document(left + width + 30, top + height + 64 + 16 * len(lines), title)


def height(root: Node) -> int:
    """Return the number of nodes on the longest path of a schedule tree."""
    depth = {root.joint: 1}
    for node in preorder(root):
        for child in node.children:
            depth[child.joint] = depth[node.joint] + 1
    return max(depth.values())
