"""The steps of each process in shape joints, as C++ lines."""

from __future__ import annotations

from functools import partial

from adagen.emit import forces
from adagen.emit.joints.rows import function_of
from adagen.emit.messages import (
    block_calls,
    coupling_lines,
    in_a_row,
    receive_lines,
    send_lines,
)
from adagen.emit.processes import stamped
from adagen.emit.symbols import Symbols
from adagen.plan import steps as do
from adagen.plan.messages import Message
from adagen.plan.steps import Step
from adagen.plan.types import Process
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
        case do.LinkBias():
            memory = symbols.link_memory(step.link)
            mobility = symbols.bare_block(step.link)
            return [
                f"link_bias(kLinks[{step.link}], {memory}.v, {memory}.b);",
                *forces.pushes(symbols, step.link, f"{memory}.b += {mobility} * {{}};"),
            ]
        case do.StartLink():
            memory = symbols.link_memory(step.link)
            inertia = symbols.inertia(step.link)
            return [
                f"start_link({inertia}, {memory}.v, {memory}.IA, {memory}.pA);",
                *forces.pushes(symbols, step.link, f"{memory}.pA -= {{}};"),
            ]
        case do.InvertRoot():
            memory = symbols.link_memory(step.link)
            inverse = f"{symbols.block(step.block)}, {symbols.bias(step.bias)}"
            return [
                f"if (!invert({memory}.IA, {memory}.pA, {inverse}))",
                f"  fail(w, kFactorization, {step.link - 1});",
            ]
        case do.SolveRoot():
            memory = symbols.link_memory(step.link)
            return [
                f"if (!solve_root({memory}.IA, {memory}.pA, {memory}.a))",
                f"  fail(w, kFactorization, {step.link - 1});",
            ]
        case do.Load():
            load = "Columns6::Zero()" if step.force is None else symbols.force(step.force)
            return [f"{symbols.link_memory(step.link)}.load = {load};"]
        case do.AccelerateRoot():
            memory, b = symbols.link_memory(step.link), symbols.bias(step.bias)
            return [f"{memory}.a = {b} + {symbols.block(step.block)} * {memory}.load;"]
        case do.Send():
            calls = _calls(symbols, step.message, "put", "to")
            return send_lines(symbols, step.message, calls)
        case do.Receive():
            calls = _calls(symbols, step.message, "get", "from")
            return receive_lines(symbols, step.message, calls)
        case do.SolveCoupling():
            rows = "std::array<std::array<Real, kColumns>, kColumns - 1>"
            return coupling_lines(symbols, rows, lambda j: f"{symbols.memory(j)}.qdd[0]")
        case do.ApplyCoupling():
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


def _calls(symbols: Symbols, number: int, verb: str, place: str) -> list[str]:
    """The calls that put what is in a message there, or get it."""
    message = symbols.plan.messages[number]
    others = [f"{verb}({place}, {item})" for item in _contents(symbols, message)]
    return in_a_row(place, [*block_calls(symbols, message, verb, place), *others])
