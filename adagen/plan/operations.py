"""Number of operations of a plan: multiplications and additions of its steps.

The formulas are counted with dense 3x3 blocks, symmetric 6x6 matrices as 21 numbers, and selections
for free. Zeros and ones in constants save nothing, so counts compare plans independently of the
shape of their code. A sine or cosine counts as one operation.
"""

from __future__ import annotations

from adagen.model import INVERSE_INERTIA, LINK_ACCELERATION, REACTION_FORCE
from adagen.model.kinds import KINDS
from adagen.plan import steps as do
from adagen.plan.requested_outputs import needed_outwards
from adagen.plan.steps import Step
from adagen.plan.types import Plan

_TURN = 15  # a 3x3 matrix times a vector
_CROSS = 9
_MOVE = 2 * _TURN + _CROSS + 3  # a spatial vector into another frame
_MOVE_INERTIA = 3 * 2 * 45 + 4 * 27  # three blocks turned on both sides, then shifted
_MOVE_BLOCK = 6 * _MOVE
_DENSE = 66  # a 6x6 matrix times a vector
_FACTORIZE = {n: (2 * n**3 + 3 * n**2 + n) // 6 for n in range(7)}  # Cholesky
_OUTPUT = {
    LINK_ACCELERATION: 2 * _TURN + 45,
    REACTION_FORCE: _DENSE + 2 * _TURN,
    INVERSE_INERTIA: 648,
}
_PLACE = {"revolute": 20, "prismatic": 6, "planar": 32, "spherical": 75, "floating": 93}

_OfJoint = do.Kinematics | do.Join | do.Disassemble | do.Articulate | do.Propagate | do.Deliver


def operations(plan: Plan) -> int:
    """Return the operations of one evaluation, of all processes together."""
    return sum(
        _of(plan, step)
        for process in plan.processes
        for needed in [needed_outwards(plan, process.steps)]
        for step in process.steps
        if not isinstance(step, do.Accelerate | do.FreeAcceleration) or step.joint in needed
    )


def _of(plan: Plan, step: Step) -> int:
    columns = plan.right_hand_sides
    match step:
        case do.LinkBias():
            return 4 * _TURN + 6 * _CROSS
        case do.StartLink():
            return 2 * _TURN + 6 * _CROSS + 12
        case do.FreeBase():
            return 6 * columns
        case do.FreeAcceleration():
            return (_MOVE + 6) * columns
        case do.InvertRoot():
            return _FACTORIZE[6] + 112 + _DENSE * columns
        case do.SolveRoot():
            return _FACTORIZE[6] + 72 * columns
        case do.AccelerateRoot():
            return (_DENSE + 6) * columns
        case _ if isinstance(step, _OfJoint):
            return _of_joint(plan, step, columns)
        case do.Accelerate():
            n, m = _freedom(plan, step.joint)
            return (_MOVE + 6 + _solve(n) + 2 * n * m + 2 * n) * columns
        case do.GiveOutput():
            return _OUTPUT[plan.outputs[step.output].what]
        case _:  # messages, loads and slaved joints: next to nothing
            return 0


def _of_joint(plan: Plan, step: _OfJoint, columns: int) -> int:
    n, m = _freedom(plan, step.joint)
    grounded = plan.joints[step.joint].parent == 0
    match step:
        case do.Kinematics():
            moved = 0 if grounded else _MOVE + n
            return _PLACE[plan.joints[step.joint].kind] + moved
        case do.Articulate():
            inner = _FACTORIZE[n] + _solve(n) * (m + columns)
            passed = n * m * (m + 1) + (2 * m * (n + m) + n) * columns
            beyond = _MOVE_INERTIA + 21 + (_MOVE + 6) * columns + 2 * _CROSS
            return inner + (0 if grounded and not step.reversed else passed + beyond)
        case do.Propagate():
            own = _FACTORIZE[n] + 2 * _MOVE_BLOCK + 4 * 6 * n * m + n * n
            return own + (_MOVE + 12) * columns + len(step.spreads) * (_MOVE_BLOCK + 12 * n * m)
        case do.Deliver():
            return (_MOVE + 6 + 2 * n * m + n) * columns
        case do.Join():
            side = 0 if step.a is None else 2 * _MOVE_BLOCK + 36
            pairs = len(step.blocks) * (72 * m + 36) + len(step.biases) * 12 * (m + n + 1) * columns
            own = _FACTORIZE[m] + (_MOVE + 12 + 12 * n + m * m) * columns
            return side + own + pairs + len(step.couplings) * (6 * m * m + _MOVE_BLOCK // 2)
        case do.Disassemble():
            forces = len(step.forces) * 12 * (m + n)
            return (forces + m * m + 2 * n * m + len(step.updates) * _MOVE) * columns


def _freedom(plan: Plan, joint: int) -> tuple[int, int]:
    """Return the numbers of a joint's force constraints and of its freedoms."""
    n = 0 if plan.joints[joint].prescribed else KINDS[plan.joints[joint].kind].nv
    return n, 6 - n


def _solve(n: int) -> int:
    """Return the operations to solve with a factored n x n matrix."""
    return 2 * n * n
