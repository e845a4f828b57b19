"""Read a robot, compile it, simulate it under a torque law written in Python, and plot.

Cells begin with `# %%`, as notebooks of Jupyter, VS Code and Spyder take them; or all at once:
python docs/how_to/example_simulation.py [PICTURE].
"""

# %% Read and compile
import sys
from pathlib import Path

import matplotlib as mpl
import numpy as np

import adagen

mpl.use("Agg")
from matplotlib import pyplot as plt

robot = adagen.read(Path(__file__).parents[2] / "generated_examples" / "models" / "arm7.urdf")
compiled = adagen.compile(robot, runtime="gravity")  # gravity can be changed below
print(f"{robot.name}: {compiled.predicted:.2f} us an evaluation, {compiled.digits:.0f} digits")
model = compiled.build()  # what the torque law knows of the robot
world = compiled.build()  # the robot itself

# %% A torque law: computed torque
# Joints are to behave like damped springs about a goal. Accelerations are linear in the torques,
# qdd = H^-1 tau + qdd0: one call with a state for each torque alone, and one for none, gives both.
goal = model.pack({"base_yaw": 0.8, "shoulder_pitch": 0.6, "elbow_pitch": -1.2})
stiffness, damping = 25.0, 10.0  # 1/s^2, 1/s: each joint is critically damped
unit_torques = np.vstack([np.zeros(model.nv), np.eye(model.nv)])


def torque_law(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Return torques, shape (nv,), that make joints follow the springs."""
    states = len(unit_torques)
    found = model(np.tile(q, (states, 1)), np.tile(v, (states, 1)), unit_torques)
    inverse_inertia = (found[1:] - found[0]).T
    wanted = stiffness * (goal - q) - damping * v
    return np.linalg.solve(inverse_inertia, wanted - found[0])


# %% Simulate: a loop of 1 kHz, velocities first
def simulate(seconds: float, step: float = 1e-3) -> tuple[np.ndarray, np.ndarray]:
    """Return times, shape (T,), and positions, shape (T, nq), from rest at zero."""
    q, v = world.pack({}), world.pack({}, of="v")
    times, positions = [0.0], [q]
    for k in range(round(seconds / step)):
        v = v + step * world(q, v, torque_law(q, v))
        q = q + step * v  # all joints have one freedom
        times.append((k + 1) * step)
        positions.append(q)
    return np.array(times), np.array(positions)


times, on_earth = simulate(2.0)
expected = goal * (1 - (1 + 5 * times) * np.exp(-5 * times))[:, None]  # of critical damping
print(f"off the springs by at most {np.abs(on_earth - expected).max():.4f} rad")

# %% The same law where gravity is another one, of which it does not know
world.gravity = (0, 0, -1.62)
_, on_moon = simulate(2.0)
print(f"on the moon it comes to rest {np.abs(on_moon[-1] - goal).max():.2f} rad off its goal")
world.gravity = model.gravity

# %% Many at once: 500 arms let go, each from another angle of its shoulder
count, step = 500, 1e-3
shoulder = model.index("shoulder_pitch")
started = np.linspace(0.1, 1.5, count)
q, v, no_torques = np.zeros((count, model.nq)), *np.zeros((2, count, model.nv))
q[:, shoulder] = started
for _ in range(250):
    v = v + step * world(q, v, no_torques)
    q = q + step * v
fallen = q[:, shoulder] - started
print(f"after 0.25 s shoulders have fallen by {fallen.min():.2f} to {fallen.max():.2f} rad")

# %% Plot
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.2), layout="constrained")
for name in ("base_yaw", "shoulder_pitch", "elbow_pitch"):
    k = model.index(name)
    (line,) = left.plot(times, on_earth[:, k], label=name)
    left.plot(times, on_moon[:, k], "--", color=line.get_color())
left.set(xlabel="time, s", ylabel="rad", title="on earth, and dashed on the moon")
left.legend()
right.plot(started, q[:, shoulder])
right.set(xlabel="shoulder when let go, rad", ylabel="rad", title="and 0.25 s later")
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "simulation.svg")
