"""The steps of each process in shape joints, as C++ lines."""

from __future__ import annotations

from functools import partial

from adagen.emit import forces
from adagen.emit.joints.rows import function_of
from adagen.emit.processes import block_calls, describe_message, in_a_row
from adagen.emit.stages import stamped
from adagen.emit.symbols import Symbols
from adagen.plan.steps import (
    AccelerateRoot,
    ApplyCoupling,
    InvertRoot,
    LinkBias,
    Load,
    Receive,
    Send,
    SolveCoupling,
    SolveRoot,
    StartLink,
    Step,
)
from adagen.plan.types import Message, Process
from adagen.program import Operation


def step_rows(symbols: Symbols) -> list[list[str]]:
    """Return the steps of each process as lines."""
    processes = zip(symbols.plan.processes, symbols.program.processes, strict=True)
    return [
        stamped(process, own.operations, partial(_lines, symbols, process))
        for process, own in processes
    ]


def _lines(symbols: Symbols, process: Process, operation: Operation) -> list[str]:
    return [line for step in operation.steps for line in step_lines(symbols, process, step)]


def step_lines(symbols: Symbols, process: Process, step: Step) -> list[str]:
    """Return the lines of a step of a process."""
    function = function_of(symbols, step)
    if function is not None:
        return [f"{function}(w);"]
    match step:
        case LinkBias():
            memory = symbols.link_memory(step.link)
            mobility = symbols.bare_block(step.link)
            return [
                f"link_bias(kLinks[{step.link}], {memory}.v, {memory}.b);",
                *forces.pushes(symbols, step.link, f"{memory}.b += {mobility} * {{}};"),
            ]
        case StartLink():
            memory = symbols.link_memory(step.link)
            inertia = symbols.inertia(step.link)
            return [
                f"start_link({inertia}, {memory}.v, {memory}.IA, {memory}.pA);",
                *forces.pushes(symbols, step.link, f"{memory}.pA -= {{}};"),
            ]
        case InvertRoot():
            memory = symbols.link_memory(step.link)
            inverse = f"{symbols.block(step.block)}, {symbols.bias(step.bias)}"
            return [
                f"if (!invert({memory}.IA, {memory}.pA, {inverse}))",
                f"  fail(w, kFactorization, {step.link - 1});",
            ]
        case SolveRoot():
            memory = symbols.link_memory(step.link)
            return [
                f"if (!solve_root({memory}.IA, {memory}.pA, {memory}.a))",
                f"  fail(w, kFactorization, {step.link - 1});",
            ]
        case Load():
            load = "Columns6::Zero()" if step.force is None else symbols.force(step.force)
            return [f"{symbols.link_memory(step.link)}.load = {load};"]
        case AccelerateRoot():
            memory, b = symbols.link_memory(step.link), symbols.bias(step.bias)
            return [f"{memory}.a = {b} + {symbols.block(step.block)} * {memory}.load;"]
        case Send():
            return _send(symbols, step.message)
        case Receive():
            return _receive(symbols, step.message)
        case SolveCoupling():
            return _solve_coupling(symbols)
        case ApplyCoupling():
            return [
                f"store_coupled(w, {j}, {symbols.plan.joints[j].v}, {memory}.qdd, w.coupling);"
                for j, memory in ((j, symbols.memory(j)) for j in process.owns)
            ]
        case _:
            raise AssertionError(f"no code for {step}")  # every other step is a joint's function


def _contents(symbols: Symbols, message: Message) -> list[str]:
    if message.sweep == "torques":
        return ["w.coupling"]
    return [
        *(symbols.bias(bias) for bias in message.biases),
        *(symbols.force(force) for force in message.forces),
        *(f"{symbols.memory(j)}.qdd[0]" for j in message.joints),
    ]


def _calls(symbols: Symbols, message: Message, verb: str, place: str) -> list[str]:
    """The calls that put what is in a message there, or get it."""
    others = [f"{verb}({place}, {item})" for item in _contents(symbols, message)]
    return [*block_calls(symbols, message, verb, place), *others]


def _send(symbols: Symbols, number: int) -> list[str]:
    message = symbols.plan.messages[number]
    return [
        f"{{  // to process {message.target}: {describe_message(symbols, message)}",
        f"  Number* to = channel.outgoing({number}, w.status);",
        *in_a_row("to", _calls(symbols, message, "put", "to")),
        f"  channel.send({number}, w.status);",
        "}",
    ]


def _receive(symbols: Symbols, number: int) -> list[str]:
    message = symbols.plan.messages[number]
    return [
        f"{{  // from process {message.source}: {describe_message(symbols, message)}",
        f"  const Number* from = channel.receive({number}, w.status);",
        *in_a_row("from", _calls(symbols, message, "get", "from")),
        "}",
    ]


def _solve_coupling(symbols: Symbols) -> list[str]:
    plan = symbols.plan
    lines = ["{", "  std::array<std::array<Real, kColumns>, kColumns - 1> rows;"]
    for k, slaved in enumerate(plan.slaved):
        mimic = plan.joints[slaved].mimic
        assert mimic is not None  # that is what slaved means
        lines.append(
            f"  coupling_row(rows[{k}], {symbols.memory(slaved)}.qdd[0], "
            f"{symbols.memory(mimic[0])}.qdd[0], {mimic[1]!r});"
        )
    return [*lines, f"  solve_coupling(w, {plan.slaved[0]}, rows, w.coupling);", "}"]
