"""A push is planned by its derivatives: a box on a table shall come to rest at a given pose.

    python jax_plan_push.py

A finger presses on one point of the box's side, with a force that is constant over each fifth of a second, and lets go. The
pose at the end is a function of the forces, through 200 implicit steps with exact friction of the whole face: Newton's
method on it, of Gauss and with the shortest step, finds the forces. Nothing is learnt.
"""

from __future__ import annotations

import jax
import jax.numpy as jnp
import tribos
import tribos.jax

MASS, LOAD = 2.0, 19.6  # kg, N
INERTIA = MASS * (0.3**2 + 0.2**2) / 12.0  # kg m²
BOX = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4)
POINT = jnp.array([0.03, -0.1])  # of the box, m
DT, STEPS, PARTS = 0.005, 200, 4  # s
GOAL = jnp.array([-0.05, 0.15, 0.6])  # m, m, rad


def end(forces: jax.Array) -> jax.Array:
    """Place and angle of the box after forces to its right and ahead, in N, of shape (parts, 2)."""
    each = jnp.repeat(forces, STEPS // (PARTS + 1), axis=0)
    each = jnp.concatenate([each, jnp.zeros((STEPS - len(each), 2))])

    def step(state: tuple[jax.Array, jax.Array], force: jax.Array) -> tuple[object, None]:
        pose, twist = state
        cos, sin = jnp.cos(pose[2]), jnp.sin(pose[2])
        torque = POINT[0] * force[1] - POINT[1] * force[0]
        push = jnp.array([cos * force[0] - sin * force[1], sin * force[0] + cos * force[1], torque])
        body = {"mass": MASS, "inertia": INERTIA, "dt": DT, "angle": pose[2]}
        after = tribos.jax.planar_step(BOX, twist, push, LOAD, **body).twists
        return (pose + 0.5 * DT * (twist + after), after), None

    return jax.lax.scan(step, (jnp.zeros(3), jnp.zeros(3)), each)[0][0]


@jax.jit
def missing(forces: jax.Array) -> tuple[jax.Array, jax.Array]:
    """The pose that is missing, and its derivatives by the forces."""

    def twice(forces: jax.Array) -> tuple[jax.Array, jax.Array]:
        pose = end(forces)
        return pose, pose

    by, pose = jax.jacfwd(twice, has_aux=True)(forces)
    return GOAL - pose, by.reshape(3, -1)


def main() -> None:
    forces = jnp.tile(jnp.array([0.0, 9.0]), (PARTS, 1))
    for steps in range(7):
        left, by = missing(forces)
        if steps in (0, 6):
            distance, turn = 1e3 * jnp.hypot(left[0], left[1]), jnp.degrees(jnp.abs(left[2]))
            print(f"after {steps} steps {distance:.2f} mm and {turn:.2f} degrees are missing")
        # The shortest change that would mend it were the pose linear; at most 2 N.
        change = by.T @ jnp.linalg.solve(by @ by.T, left)
        change = change * jnp.minimum(1.0, 2.0 / jnp.abs(change).max())
        forces = forces + change.reshape(forces.shape)
    for name, column in (("ahead", 1), ("to the right", 0)):
        print(f"forces {name}:", " ".join(f"{force:.2f}" for force in forces[:, column]), "N")


if __name__ == "__main__":
    main()
