"""Joins in shape `kernels`: mobilities outwards, joins, and forces back, as C++ lines.

Blocks and biases are in the same axes as their links' bodies; a join rotates its operands into its
joint's frame (adagen/kernels/mobility.hpp) and then is that of shape `joints`.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import replace

from adagen.emit import forces
from adagen.emit.joints import fused, joins
from adagen.emit.joints.fused import freedoms, type_of
from adagen.emit.symbols import Symbols
from adagen.plan import Plan
from adagen.plan import steps as do
from adagen.plan.edges import is_free_base
from adagen.plan.steps import Bias, Force, Step, biases_set_by, blocks_set_by
from adagen.program import Operation, Program
from adagen.program.runs import Run, ends_of_run

CARRIED = ("carried", "along")
"""Methods by which wrenches are carried through runs."""

STEPS = (
    do.InvertRoot
    | do.LinkBias
    | do.Propagate
    | do.Join
    | do.FusedJoin
    | do.Disassemble
    | do.Load
    | do.LoadRoot
    | do.Deliver
    | do.AccelerateRoot
    | do.SolveMobility
    | do.HoldMobility
)


def has_cuts(plan: Plan) -> bool:
    """Return whether processes of a plan exchange mobilities."""
    return any(isinstance(step, STEPS) for step in plan.steps)


def holds_ground(plan: Plan) -> bool:
    """Return whether a process inverts the mobility of the ground's side."""
    return any(isinstance(step, do.HoldMobility) for step in plan.all_steps)


def carries(program: Program) -> bool:
    """Return whether unit wrenches are carried through runs."""
    return any(
        operation.method in (*CARRIED, "parts")
        for own in program.processes
        for operation in (*own.operations, *own.recovery)
    )


def has_fused(plan: Plan) -> bool:
    """Return whether runs of joints are joined as one."""
    return any(plan.steps_of(do.FusedJoin))


def runtime(plan: Plan) -> list[str]:
    """Return the parts of the runtime that joins need."""
    joined = {step.joint for step in plan.all_steps if isinstance(step, do.Join)}
    held = any(plan.joints[j].prescribed or plan.joints[j].rotor_inertia for j in joined)
    runs = ["fused.hpp"] * has_fused(plan)
    return ["spatial.hpp", "joins.hpp", *runs, *["effects.hpp"] * held]


def passes_free(plan: Plan) -> bool:
    """Return whether mobilities are carried outwards across floating joints."""
    return any(
        isinstance(step, do.Propagate) and plan.joints[step.joint].kind == "floating"
        for step in plan.all_steps
    )


def members(symbols: Symbols) -> dict[int, list[str]]:
    """Return the memory members of joints that have any."""
    lines: dict[int, dict[str, None]] = defaultdict(dict)
    forces: set[Force] = set()
    computed = list(_computed(symbols.program))
    for step in (*computed, *_joining_parts(symbols.program)):
        for block in blocks_set_by(step):
            assert block.joint is not None  # bare links' blocks are constants
            lines[block.joint][f"Mat6 {symbols.block_member(block)};"] = None
        for bias in biases_set_by(step):
            assert bias.joint is not None
            lines[bias.joint][f"Columns6 b_{symbols.links[bias.handle]};"] = None
    for step in computed:
        if isinstance(step, do.LinkBias):
            lines[step.link - 1]["Columns6 b;"] = None
        if isinstance(step, do.Join):
            lines[step.joint].update(dict.fromkeys(_members_of_join(symbols, step)))
        if isinstance(step, do.Disassemble):
            forces |= {update.target for update in step.updates}
    for force in sorted(forces):
        lines[force.joint][f"Columns6 {symbols.force_member(force)};"] = None
    return {joint: list(lines[joint]) for joint in sorted(lines)}


def _computed(program: Program) -> Iterator[Step]:
    """Yield the steps whose results are all stored: of a run with carried wrenches the last one."""
    for own in program.processes:
        for operation in (*own.operations, *own.recovery):
            if operation.method == "parts":
                continue  # they hand on what they find in variables
            if operation.method in CARRIED:
                yield operation.steps[-1]
            else:
                yield from operation.steps


def _joining_parts(program: Program) -> Iterator[do.Join]:
    """Yield the joins by which parts become one chain: what that shows is stored."""
    for own in program.processes:
        for operation in own.operations:
            if (operation.does, operation.method) == ("join", "parts"):
                yield _last_join(operation)


def _members_of_join(symbols: Symbols, join: do.Join) -> list[str]:
    if isinstance(join, do.FusedJoin):
        kind = type_of(symbols, join)
        lines = [f"Run<{freedoms(symbols, join)}> run;"]
    else:
        kind = forces.joined_type(symbols, join.joint)
        lines = ["Transform X, Y;  // to the joint's frame, about its two links' origins"]
        if symbols.plan.joints[join.joint].rotor_inertia:
            torque = forces.freedoms_type(symbols, join.joint)
            lines.append(f"{torque} tau;  // drives rotor and joint")
    handles = [symbols.links[coupling.handle] for coupling in join.couplings]
    return [*lines, f"Joined<{kind}> joined;", *(f"Coupled<{kind}> at_{h};" for h in handles)]


def lines_of(symbols: Symbols, p: int, step: Step) -> list[str]:
    """Return the lines of one of ``STEPS`` on process p.

    What is carried out run by run has functions of its own: ``propagation``, ``delivery``.
    """
    match step:
        case do.InvertRoot():
            phi, b = symbols.block(step.block), symbols.bias(step.bias)
            return [f"invert_root<{p}, {step.link}>(w, {phi}, {b});"]
        case do.LinkBias():
            phi, b = symbols.bare_block(step.link), symbols.bias(Bias(None, step.link))
            return [f"bare_link<{step.link}>(w, {phi}, {b});"]
        case do.Join():
            return _scoped(_assembly(symbols, step))
        case do.Disassemble():
            return _scoped(_disassembly(symbols, step))
        case do.Load(link, force):
            load = (
                "Columns6::Zero()"
                if force is None
                else f"in_base(w, {link}, {symbols.force(force)})"
            )
            return [f"w.loads[{link}] = {load};"]
        case do.LoadRoot():
            sign = "" if step.held else "-"
            return [f"w.loads[{step.link}] = {sign}force_on<{step.link}>(w);"]
        case do.HoldMobility():
            phi, b = symbols.block(step.block), symbols.bias(step.bias)
            return [f"hold<{step.link}>(w, {phi}, {b});"]
        case do.AccelerateRoot():
            b, phi = symbols.bias(step.bias), symbols.block(step.block)
            return [f"accelerate_root<{step.link}>(w, {phi}, {b});"]
        case do.SolveMobility():
            phi, b = symbols.block(step.block), symbols.bias(step.bias)
            return [f"solve_mobility<{step.link}>(w, {phi}, {b});"]
    raise AssertionError(f"no code for {step}")


def _assembly(symbols: Symbols, step: do.Join) -> list[str]:
    if isinstance(step, do.FusedJoin):
        return fused.assembly(symbols, step, turned=True)
    turned = replace(step, velocity_product=False)
    return [
        f"auto& i = {symbols.memory(step.joint)};",
        f"set_transforms(w, {step.joint}, i.X, i.Y);",
        *joins.assembly(symbols, turned, turned=True)[1:],
    ]


def _disassembly(symbols: Symbols, step: do.Disassemble) -> list[str]:
    join = next(one for one in symbols.plan.steps_of(do.Join) if one.joint == step.joint)
    if isinstance(join, do.FusedJoin):
        return fused.disassembly(symbols, join, step, turned=True)
    lines = joins.disassembly(symbols, join, step, turned=True)
    if is_free_base(symbols.plan.joints[step.joint]):
        lines.append(f"as_joint_acceleration<{step.joint}>(w);")
    return lines


def way_of(run: Run) -> str:
    """Return the variable with the results of wrenches carried through a run."""
    return f"way_{run.first}"


def swept_parts(run: Run) -> str:
    """Return the variable that tells what the sweep of a run's parts finds."""
    return f"swept_{run.first}"


OF_PARTS = ("propagate", "join", "disassemble", "accelerate_root")
"""What is done of all parts of a run at once, each by a call and with a variable for the next."""


def lines_of_parts(symbols: Symbols, operation: Operation) -> list[str]:
    """Return the lines of one of ``OF_PARTS``."""
    run = operation.block
    assert isinstance(run, Run)
    k, ends = run.first, f"{run.first}, {run.last}"
    match operation.does:
        case "propagate":
            return [f"ShownParts shown_{k} = show_parts<{ends}>(w, {swept_parts(run)});"]
        case "join":
            whole = ", ".join(_shown_by_whole(symbols, operation))
            call = f"join_parts<{ends}>(w, shown_{k}.ends, {{{whole}}});"
            return [f"const JoinedParts joined_{k} = {call}"]
        case "disassemble":
            release = operation.steps[0]
            assert isinstance(release, do.Disassemble)
            outer = [symbols.force(force) for force in release.forces]
            on_ground = symbols.plan.joints[release.joint].parent == 0
            on = ", ".join([*["Columns6::Zero()"] * on_ground, *outer, "Columns6::Zero()"][:2])
            return [f"const EndForces forces_{k} = release_parts<{ends}>(w, joined_{k}, {on});"]
    call = f"start_parts({swept_parts(run)}, shown_{k}, forces_{k});"
    return [f"const StartedParts started_{k} = {call}"]


def accelerated_parts(run: Run, *, weighed: bool) -> str:
    """Return the call that sweeps the parts of a run outwards.

    Args:
        run: the run.
        weighed: whether the links are weighed meanwhile, for a certificate.
    """
    ends, started = f"<{run.first}, {run.last}>", f"(w, started_{run.first});"
    if weighed:
        return f"const MovedParts moved_{run.first} = accelerate_weighed_in_parts{ends}{started}"
    return f"accelerate_in_parts{ends}{started}"


def weighed_parts(run: Run) -> list[str]:
    """Return the lines of the certificate of a run in parts."""
    k = run.first
    found = f"swept_{k}, shown_{k}, forces_{k}, started_{k}, moved_{k}"
    return [
        "begin_weighing(w);",
        f"weigh_parts<{run.first}, {run.last}>(w, {found});",
        "end_weighing(w);",
    ]


def _last_join(operation: Operation) -> do.Join:
    """The join by which the parts of a run become one chain."""
    step = operation.steps[-1]
    assert isinstance(step, do.Join)
    return step


def _shown_by_whole(symbols: Symbols, operation: Operation) -> tuple[str, ...]:
    """Where the mobility of joined parts is put: of the first link, then what the last one has."""
    last = _last_join(operation)
    blocks = [f"&{symbols.block(block)}" for block in sorted(blocks_set_by(last))]
    biases = [f"&{symbols.bias(bias)}" for bias in sorted(biases_set_by(last))]
    nothing = "nullptr"
    if last.a is None:  # the ground holds the first link
        blocks, biases = [nothing, nothing, *blocks], [nothing, *biases]
    near, across, far = [*blocks, nothing, nothing, nothing][:3]
    near_bias, far_bias = [*biases, nothing, nothing][:2]
    return near, near_bias, far, across, far_bias


def propagation(symbols: Symbols, operation: Operation) -> list[str]:
    """Return the lines of an operation that carries mobilities outwards."""
    steps = [step for step in operation.steps if isinstance(step, do.Propagate)]
    first, last = steps[0], steps[-1]
    if operation.method not in CARRIED:
        return _propagate(symbols, first)
    run = operation.block
    assert isinstance(run, Run)
    target = f"{symbols.block(last.block)}, {symbols.bias(last.bias)}"
    way = way_of(run)
    if first.near is None or first.near_bias is None:
        shown = f"show<{run.last + 1}>(w, {way}, {target});"
    else:
        shown = (
            f"show({way}, {symbols.block(first.near)}, {symbols.bias(first.near_bias)}, {target});"
        )
    lines = [shown, *_coupled(symbols, run, first, last)]
    if operation.method == "along":
        return lines
    turned = "true" if run.reversed else "false"
    return [
        f"{{  // {symbols.span(run.first, run.last)}",
        f"  const Way {way} = carry<{turned}, {run.first}, {run.last}>(w);",
        *(f"  {line}" for line in lines),
        "}",
    ]


def _coupled(symbols: Symbols, run: Run, first: do.Propagate, last: do.Propagate) -> Iterator[str]:
    """Couplings of handles with a run's last link, from those with its first link."""
    for spread, begun in zip(last.spreads, first.spreads, strict=True):
        source = symbols.block(begun.source) + ".transpose()" * begun.source_transposed
        product = f"{way_of(run)}.moved * {source}"
        if spread.target_transposed:
            product = f"({product}).transpose()"
        handle = symbols.quoted_link(spread.handle)
        yield f"{symbols.block(spread.target)} = {product};  // with link {handle}"


def delivery(symbols: Symbols, run: Run, *, through: bool = False) -> str:
    """Return the call that carries handle forces back through a run.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        run: the run.
        through: whether nothing else acts on the links between its ends.
    """
    joints = symbols.plan.joints
    if not joints[run.first].prescribed:
        ends = f"{run.first}, {run.last}{', true' * through}"
        return f"deliver{'_reversed' * run.reversed}<{ends}>(w);"
    near, far = ends_of_run(joints, run)
    turned = "true" if run.reversed else "false"
    return f"deliver_prescribed<{turned}>(w, {run.first}, w.loads[{far}], w.loads[{near}]);"


def _scoped(lines: list[str]) -> list[str]:
    return ["{", *(f"  {line}" for line in lines), "}"]


def _of(symbols: Symbols, step: do.Propagate, verb: str) -> str:
    """The function that carries a quantity across a joint."""
    prescribed = "_prescribed" if symbols.plan.joints[step.joint].prescribed else ""
    return f"{verb}{prescribed}<{'true' if step.reversed else 'false'}>"


def _propagate(symbols: Symbols, step: do.Propagate) -> list[str]:
    near = "kZero" if step.near is None else symbols.block(step.near)
    near_bias = "kGround" if step.near_bias is None else symbols.bias(step.near_bias)
    far = f"{symbols.block(step.block)}, {symbols.bias(step.bias)}"
    call = _of(symbols, step, "propagate")
    lines = [f"{call}(w, {step.joint}, {near}, {near_bias}, {far});"]
    passed = _of(symbols, step, "passed")
    for spread in step.spreads:
        source = symbols.block(spread.source)
        source += ".transpose()" if spread.source_transposed else ""
        target = ".transpose()" if spread.target_transposed else ""
        handle = symbols.quoted_link(spread.handle)
        lines.append(
            f"{symbols.block(spread.target)} = {passed}(w, {step.joint}, {source}){target};"
            f"  // with link {handle}"
        )
    return lines
