"""Kinematics of a joint as C++ lines, its constants folded in."""

from __future__ import annotations

from adagen.emit.symbols import Symbols


def kinematics_lines(symbols: Symbols, j: int) -> list[str]:
    """Return the lines that set X_j and the velocity of the child link from q and v."""
    joint, kind = symbols.plan.joints[j], symbols.kind(j)
    source = symbols.plan.source_of(j)
    state = symbols.plan.joints[source]
    lines = [
        f"auto& i = {symbols.memory(j)};",
        f"require_finite(w, w.q + {state.q}, {kind.nq}, {source});",
        f"require_finite(w, w.v + {state.v}, {kind.nv}, {source});",
        *configuration(symbols, j),
        *_PLACES[kind.name](symbols, j),
    ]
    motion = velocity(symbols, j)
    if joint.parent == 0:
        lines.append(f"i.v = joint_velocity<{symbols.type_of(j)}>({motion});")
    else:
        above = symbols.memory(joint.parent - 1)
        lines.append(f"i.v = i.X * {above}.v + joint_velocity<{symbols.type_of(j)}>({motion});")
    return lines


def configuration(symbols: Symbols, j: int) -> list[str]:
    """Return the line that names the joint's configuration q and, for a slaved joint, velocity."""
    joint = symbols.plan.joints[j]
    if joint.mimic is None:
        if symbols.kind(j).name == "revolute":
            return [f"const Real q = Real(w.q[{joint.q}]), c = std::cos(q), s = std::sin(q);"]
        if symbols.kind(j).nq == 1:
            return [f"const Real q = Real(w.q[{joint.q}]);"]
        return [f"const Number* const q = w.q + {joint.q};"]
    source, multiplier, offset = joint.mimic
    q, v = symbols.plan.joints[source].q, symbols.plan.joints[source].v
    linear = symbols.printer.linear
    return [
        f"const Real q = {linear([(multiplier, f'w.q[{q}]')], offset)};"
        f"  // slaved to {symbols.quoted_joint(source)}",
        f"const Number qd = {linear([(multiplier, f'w.v[{v}]')])};",
    ]


def velocity(symbols: Symbols, j: int) -> str:
    """Return the pointer to a joint's velocity, within the scope of ``configuration``."""
    joint = symbols.plan.joints[j]
    return f"w.v + {joint.v}" if joint.mimic is None else "&qd"


def _matrix(entries: list[list[str]]) -> list[str]:
    return [f"i.X.E << {',  '.join(', '.join(row) for row in entries)};  // row by row"]


def _origin(symbols: Symbols, j: int, shift: list[list[tuple[float, str]]] | None = None) -> str:
    """The origin of the child frame: constant, plus what the configuration adds."""
    joint = symbols.plan.joints[j]
    entries = [
        symbols.printer.linear(shift[k] if shift else [], joint.translation[k]) for k in range(3)
    ]
    return f"i.X.r << {', '.join(entries)};"


def _turned(symbols: Symbols, j: int) -> list[list[str]]:
    """E = Rz(q)^T R^T, R being the joint frame's rotation."""
    rotation = symbols.plan.joints[j].rotation
    linear = symbols.printer.linear
    return [
        [linear([(rotation[k][0], "c"), (rotation[k][1], "s")]) for k in range(3)],
        [linear([(rotation[k][1], "c"), (-rotation[k][0], "s")]) for k in range(3)],
        [linear([], rotation[k][2]) for k in range(3)],
    ]


def _revolute(symbols: Symbols, j: int) -> list[str]:
    slaved = ["const Real c = std::cos(q), s = std::sin(q);"]
    own = [] if symbols.plan.joints[j].mimic is None else slaved
    return [*own, *_matrix(_turned(symbols, j)), _origin(symbols, j)]


def _prismatic(symbols: Symbols, j: int) -> list[str]:
    rotation = symbols.plan.joints[j].rotation
    entries = [[symbols.printer.linear([], rotation[k][i]) for k in range(3)] for i in range(3)]
    shift = [[(rotation[k][2], "q")] for k in range(3)]
    return [*_matrix(entries), _origin(symbols, j, shift)]


def _planar(symbols: Symbols, j: int) -> list[str]:
    rotation = symbols.plan.joints[j].rotation
    shift = [[(rotation[k][0], "q[0]"), (rotation[k][1], "q[1]")] for k in range(3)]
    return [
        "const Real c = std::cos(q[2]), s = std::sin(q[2]);",
        *_matrix(_turned(symbols, j)),
        _origin(symbols, j, shift),
    ]


def _oriented(symbols: Symbols, j: int, quaternion: str) -> list[str]:
    """E = Q R^T, Q turning joint coordinates into child coordinates."""
    rotation = symbols.plan.joints[j].rotation
    if all(rotation[i][k] == float(i == k) for i in range(3) for k in range(3)):
        return [f"require_length(w, conjugate_rotation({quaternion}, i.X.E), {j});"]
    entries = [
        [
            symbols.printer.linear([(rotation[k][m], f"Q({i}, {m})") for m in range(3)])
            for k in range(3)
        ]
        for i in range(3)
    ]
    return [
        "Mat3 Q;",
        f"require_length(w, conjugate_rotation({quaternion}, Q), {j});",
        *_matrix(entries),
    ]


def _spherical(symbols: Symbols, j: int) -> list[str]:
    return [*_oriented(symbols, j, "q"), _origin(symbols, j)]


def _floating(symbols: Symbols, j: int) -> list[str]:
    rotation = symbols.plan.joints[j].rotation
    shift = [[(rotation[k][m], f"q[{m}]") for m in range(3)] for k in range(3)]
    return [*_oriented(symbols, j, "q + 3"), _origin(symbols, j, shift)]


_PLACES = {
    "revolute": _revolute,
    "prismatic": _prismatic,
    "planar": _planar,
    "spherical": _spherical,
    "floating": _floating,
}
