"""The model's constants for the template model.cpp.j2: joints, links and outer forces."""

from __future__ import annotations

from adagen.emit import forces
from adagen.emit.names import identifiers, quoted
from adagen.emit.symbols import Symbols
from adagen.model.kinds import KINDS
from adagen.model.loops import LOOP_KINDS
from adagen.plan import Plan
from adagen.plan.robot import PlanLink
from adagen.plan.steps import LinkBias, StartLink


def model_values(symbols: Symbols) -> dict[str, object]:
    """Return the robot's values for the template."""
    plan = symbols.plan
    return {
        "gravity": ", ".join(repr(g) for g in plan.gravity),  # m/s^2
        "parameters": [repr(x) for x in plan.parameter_values],
        "gravity_entry": plan.entry_of_parameter("gravity"),
        "settable_links": _settable_links(symbols),
        "settable": sorted({parameter.what for parameter in plan.parameters}),
        "at_run_time": [
            f"{p.what} of {quoted(p.name)}" if p.link else p.what for p in plan.parameters
        ],
        "nq": sum(KINDS[joint.kind].nq for joint in plan.joints),
        "nv": plan.nv,
        "ntau": plan.nv + 6 * len(plan.wrenches),
        "loop_forces": _forces(symbols) if plan.loop_forces else [],
        "links": _links(symbols),
        "joints": _joints(symbols),
        "outer_forces": _outer_forces(symbols),
        "closed": plan.closed,
        "loops": _loops(symbols),
        "couplings": _couplings(symbols),
        "nqdd": plan.nqdd,
        "outputs": [_output(plan, k) for k in range(len(plan.outputs))],
        "wanted": [quoted(plan.joints[j].name) for j in plan.wanted],
        "at_rest": plan.at_rest,
        "prescribed": [quoted(joint.name) for joint in plan.joints if joint.prescribed],
        "following": [quoted(joint.name) for joint in plan.joints if joint.mimic],
    }


def _links(symbols: Symbols) -> list[dict[str, object]]:
    plan = symbols.plan
    bare = {step.link for step in plan.steps_of(LinkBias)}
    started = {step.link for step in plan.steps_of(StartLink)}
    number, numbers = symbols.printer.number, symbols.printer.numbers
    return [
        {
            "bare_block": symbols.bare_block(k) if k in bare else "",
            "inertia": symbols.inertia(k) if k in started else "",
            "index": k,
            "quoted": quoted(link.name),
            "mass": number(link.mass),
            "com": numbers(link.com),
            "tensors": [numbers(tensor) for tensor in _tensors(link)],
            "phi_upper": symbols.printer.numbers(
                x for i, row in enumerate(link.phi) for x in row[i:]
            ),
        }
        for k, link in enumerate(plan.links)
    ]


def _tensors(link: PlanLink) -> list[list[float]]:
    """Return a link's tensor and its inverse, row by row; the last ones left out where all zero."""
    tensors = [[x for row in rows for x in row] for rows in (link.tensor, link.tensor_inverse)]
    while tensors and not any(tensors[-1]):
        tensors.pop()
    return tensors


def _settable_links(symbols: Symbols) -> list[dict[str, object]]:
    """Links whose mass or centre of mass can be set at run time, the ground being 0."""
    plan = symbols.plan
    rows = []
    for k in sorted({parameter.link for parameter in plan.parameters} - {0}):
        mass, center = (plan.entry_of_parameter(what, k) for what in ("mass", "center"))
        axes = next((p.rotation for p in plan.parameters if p.link == k and p.rotation), ())
        rows.append(
            {
                "word": symbols.links[k],
                "quoted": symbols.quoted_link(k),
                "link": k,
                "mass": -1 if mass is None else mass,
                "center": -1 if center is None else center,
                "axes": ", ".join(repr(x) for row in axes for x in row),
            }
        )
    return rows


def _joints(symbols: Symbols) -> list[dict[str, object]]:
    numbers = symbols.printer.numbers
    rows = []
    for j, joint in enumerate(symbols.plan.joints):
        rows.append(
            {
                "word": symbols.joints[j],
                "quoted": quoted(joint.name),
                "Kind": symbols.type_of(j),
                "parent": joint.parent,
                "q": joint.q,
                "nq": symbols.kind(j).nq,
                "v": joint.v,
                "nv": symbols.kind(j).nv,
                "rotation": numbers(x for row in joint.rotation for x in row),
                "translation": numbers(joint.translation),
                "rest": _rest_of_joint(symbols, j),
            }
        )
    return rows


def _rest_of_joint(symbols: Symbols, j: int) -> str:
    """Return the last members of JointConstants, up to the last that differs from its default.

    They are: the joint that it is slaved to, with multiplier and offset; its effects; whether its
    acceleration is wanted.
    """
    source, multiplier, offset = symbols.plan.joints[j].mimic or (-1, 0.0, 0.0)
    members = [
        (f", {source}, {multiplier!r}, {offset!r}", source >= 0),
        (forces.constants(symbols, j) or ", {}", bool(forces.constants(symbols, j))),
        (", false", not symbols.plan.wants(j)),
    ]
    while members and not members[-1][1]:
        members.pop()
    return "".join(text for text, _ in members)


def _outer_forces(symbols: Symbols) -> list[dict[str, object]]:
    numbers = symbols.printer.numbers
    return [
        {
            "quoted": quoted(wrench.name),
            "link": wrench.link,
            "rotation": numbers(x for row in wrench.rotation for x in row),
            "translation": numbers(wrench.translation),
        }
        for wrench in symbols.plan.wrenches
    ]


def _output(plan: Plan, k: int) -> dict[str, object]:
    output = plan.outputs[k]
    first = plan.entry_of_output(k)
    return {
        "quoted": quoted(output.name),
        "what": output.what,
        "first": first,
        "last": first + output.size - 1,
        "size": output.size,
    }


def _loops(symbols: Symbols) -> list[dict[str, object]]:
    numbers = symbols.printer.numbers
    rows = []
    for k, loop in enumerate(symbols.plan.loops):
        kind = LOOP_KINDS[loop.kind]
        rows.append(
            {
                "index": k,
                "quoted": quoted(loop.name),
                "link1": loop.link1,
                "link2": loop.link2,
                "rotation1": numbers(x for row in loop.rotation1 for x in row),
                "translation1": numbers(loop.translation1),
                "rotation2": numbers(x for row in loop.rotation2 for x in row),
                "translation2": numbers(loop.translation2),
                "linear": sum(1 << axis for axis in kind.linear),
                "angular": sum(1 << axis for axis in kind.angular),
                "universal": "true" if kind.axes == 2 else "false",
            }
        )
    return rows


def _forces(symbols: Symbols) -> list[dict[str, object]]:
    """Entries of loop and coupling forces in qdd."""
    plan = symbols.plan
    found = [("loop", tie.name, plan.entry_of_loop(k), 6) for k, tie in enumerate(plan.loops)]
    found += [
        ("coupling", tie.name, plan.entry_of_coupling(k), 1) for k, tie in enumerate(plan.couplings)
    ]
    names = identifiers(name for _, name, _, _ in found)
    return [
        {"word": word, "what": what, "quoted": quoted(name), "entry": entry, "count": count}
        for word, (what, name, entry, count) in zip(names, found, strict=True)
    ]


def _couplings(symbols: Symbols) -> list[dict[str, object]]:
    return [
        {
            "index": k,
            "quoted": quoted(coupling.name),
            "count": len(coupling.terms),
            "joints": ", ".join(str(j) for j, _ in coupling.terms),
            "factors": symbols.printer.numbers(factor for _, factor in coupling.terms),
            "offset": symbols.printer.number(coupling.offset),
        }
        for k, coupling in enumerate(symbols.plan.couplings)
    ]
