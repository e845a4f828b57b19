"""Each process's list of steps in shape joints, as C++ lines."""

from __future__ import annotations

from functools import partial

from adagen.emit import effects
from adagen.emit.joints.rows import function_of
from adagen.emit.processes import describe_message, in_a_row
from adagen.emit.stages import stamped
from adagen.emit.words import Words
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


def step_rows(words: Words) -> list[list[str]]:
    """Return for each process its steps as lines, one joint and step after the other."""
    processes = zip(words.plan.processes, words.program.processes, strict=True)
    return [
        stamped(process, own.operations, partial(_lines, words, process))
        for process, own in processes
    ]


def _lines(words: Words, process: Process, operation: Operation) -> list[str]:
    return [line for step in operation.steps for line in step_lines(words, process, step)]


def step_lines(words: Words, process: Process, step: Step) -> list[str]:
    """Return the lines that do a step of a process."""
    function = function_of(words, step)
    if function is not None:
        return [f"{function}(w);"]
    match step:
        case LinkBias():
            memory = words.link_memory(step.link)
            mobility = words.bare_block(step.link)
            return [
                f"link_bias(kLinks[{step.link}], {memory}.v, {memory}.b);",
                *effects.pushes(words, step.link, f"{memory}.b += {mobility} * {{}};"),
            ]
        case StartLink():
            memory = words.link_memory(step.link)
            inertia = words.inertia(step.link)
            return [
                f"start_link({inertia}, {memory}.v, {memory}.IA, {memory}.pA);",
                *effects.pushes(words, step.link, f"{memory}.pA -= {{}};"),
            ]
        case InvertRoot():
            memory = words.link_memory(step.link)
            inverse = f"{words.block(step.block)}, {words.bias(step.bias)}"
            return [
                f"if (!invert({memory}.IA, {memory}.pA, {inverse}))",
                f"  fail(w, kFactorization, {step.link - 1});",
            ]
        case SolveRoot():
            memory = words.link_memory(step.link)
            return [
                f"if (!solve_root({memory}.IA, {memory}.pA, {memory}.a))",
                f"  fail(w, kFactorization, {step.link - 1});",
            ]
        case Load():
            load = "Columns6::Zero()" if step.force is None else words.force(step.force)
            return [f"{words.link_memory(step.link)}.load = {load};"]
        case AccelerateRoot():
            memory, b = words.link_memory(step.link), words.bias(step.bias)
            return [f"{memory}.a = {b} + {words.block(step.block)} * {memory}.load;"]
        case Send():
            return _send(words, step.message)
        case Receive():
            return _receive(words, step.message)
        case SolveCoupling():
            return _solve_coupling(words)
        case ApplyCoupling():
            return [
                f"store_coupled(w, {j}, {words.plan.joints[j].v}, {memory}.qdd, w.coupling);"
                for j, memory in ((j, words.memory(j)) for j in process.owns)
            ]
        case _:
            raise AssertionError(f"no code for {step}")  # every other step is a joint's function


def _contents(words: Words, message: Message) -> list[str]:
    if message.sweep == "torques":
        return ["w.coupling"]
    return [
        *(words.block(block) for block in message.blocks),
        *(words.bias(bias) for bias in message.biases),
        *(words.force(force) for force in message.forces),
        *(f"{words.memory(j)}.qdd[0]" for j in message.joints),
    ]


def _send(words: Words, number: int) -> list[str]:
    message = words.plan.messages[number]
    return [
        f"{{  // to process {message.target}: {describe_message(words, message)}",
        f"  Number* to = channel.outgoing({number}, w.status);",
        *in_a_row("to", [f"put(to, {item})" for item in _contents(words, message)]),
        f"  channel.send({number}, w.status);",
        "}",
    ]


def _receive(words: Words, number: int) -> list[str]:
    message = words.plan.messages[number]
    return [
        f"{{  // from process {message.source}: {describe_message(words, message)}",
        f"  const Number* from = channel.receive({number}, w.status);",
        *in_a_row("from", [f"get(from, {item})" for item in _contents(words, message)]),
        "}",
    ]


def _solve_coupling(words: Words) -> list[str]:
    plan = words.plan
    lines = ["{", "  std::array<std::array<Real, kColumns>, kColumns - 1> rows;"]
    for k, slaved in enumerate(plan.slaved):
        mimic = plan.joints[slaved].mimic
        assert mimic is not None  # that is what slaved means
        lines.append(
            f"  coupling_row(rows[{k}], {words.memory(slaved)}.qdd[0], "
            f"{words.memory(mimic[0])}.qdd[0], {mimic[1]!r});"
        )
    return [*lines, f"  solve_coupling(w, {plan.slaved[0]}, rows, w.coupling);", "}"]
