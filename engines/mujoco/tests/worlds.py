"""Models with feet, and the exact motion that they are judged by."""

import math

import mujoco
import numpy as np

GRAVITY = 10.0  # m/s²
FRICTIONLESS = 'condim="1" priority="1"'
DISK = {"patch": "disk", "size": 0.05, "mu": 0.3}
BOX = {"patch": "box", "size": "0.05 0.05", "mu": 0.3}
PUCK_GEOM = f'type="cylinder" size="0.05 0.01" mass="0.2" {FRICTIONLESS}'
BOX_GEOM = f'type="box" size="0.05 0.05 0.01" mass="0.2" {FRICTIONLESS}'


def extension(feet):
    """Feet by the names of their instances, each a dict of attributes."""
    instances = "".join(
        f'<instance name="{name}">'
        + "".join(f'<config key="{key}" value="{value}"/>' for key, value in keys.items())
        + "</instance>"
        for name, keys in feet.items()
    )
    return f'<extension><plugin plugin="tribos.patch">{instances}</plugin></extension>'


def model_of(feet, bodies, *, gravity=f"0 0 -{GRAVITY}", option="", more=""):
    text = f"""
    <mujoco>
      {extension(feet)}
      <option timestep="0.001" gravity="{gravity}" {option}/>
      <worldbody>{bodies}</worldbody>
      {more}
    </mujoco>"""
    return mujoco.MjModel.from_xml_string(text)


def world(geom, keys, *, height=0.01, floor='type="plane" size="9 9 0.1"', more="", **options):
    """A body of one geom, called foot, on a floor."""
    keys = {"geom": "foot", "ground": "floor"} | keys
    bodies = f"""
      <geom name="floor" {floor}/>
      <body name="body" pos="0 0 {height}"><freejoint/><geom name="foot" {geom}/></body>{more}"""
    model = model_of({"foot": keys}, bodies, **options)
    return model, mujoco.MjData(model)


def state(model, data, name="foot"):
    """What a foot remembers: load, friction, torque about the normal, whether it is held."""
    index = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_PLUGIN, name)
    at = model.plugin_stateadr[index]
    numbers = data.plugin_state[at : at + model.plugin_statenum[index]]
    return numbers[0], numbers[1:4].copy(), numbers[4], bool(numbers[5])


def missed(model, data, name):
    """In how many steps a search for the friction of a foot stopped at its count."""
    index = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_PLUGIN, name)
    return data.plugin_state[model.plugin_stateadr[index] + 13]


def slide(model, data, speed, spin, steps=1500, settle=400):
    """Path of the body to rest, once it has settled."""
    mujoco.mj_step(model, data, nstep=settle)
    start = data.qpos[:3].copy()
    data.qvel[:6] = [speed, 0.0, 0.0, 0.0, 0.0, spin]
    mujoco.mj_step(model, data, nstep=steps)
    return data.qpos[:3] - start


def disk_nodes(radius, *, inner=0.0, power=0.0, rings=60, angles=120):
    """Points of a disk or annulus and their weights, for a pressure (1 - (r/radius)²)^power."""
    x, w = np.polynomial.legendre.leggauss(rings)
    # r² = inner² + t (radius² - inner²), and t = 1 - u² smooths the rim.
    u, w = 0.5 * (x + 1.0), 0.5 * w
    r_sq = inner**2 + (1.0 - u**2) * (radius**2 - inner**2)
    weight = w * 2.0 * u * (1.0 - r_sq / radius**2) ** power
    angle = 2.0 * np.pi * (np.arange(angles) + 0.5) / angles
    points = np.sqrt(r_sq)[:, None, None] * np.stack((np.cos(angle), np.sin(angle)), axis=-1)
    weights = np.repeat(weight[:, None], angles, axis=1)
    return points.reshape(-1, 2), weights.ravel() / weights.sum()


def box_nodes(x, y, count=80):
    """Points of a rectangle of these half lengths and their weights."""
    place = (2.0 * np.arange(count) + 1.0) / count - 1.0
    points = np.stack(np.meshgrid(x * place, y * place), axis=-1).reshape(-1, 2)
    return points, np.full(count * count, 1.0 / count**2)


def wrench(nodes, mu, load, twist):
    """Coulomb friction of points on a body with this twist, in its own axes."""
    points, weights = nodes
    velocity = np.column_stack(
        (twist[0] - twist[2] * points[:, 1], twist[1] + twist[2] * points[:, 0])
    )
    direction = velocity / np.linalg.norm(velocity, axis=1)[:, None]
    force = -mu * load * weights[:, None] * direction
    torque = np.sum(points[:, 0] * force[:, 1] - points[:, 1] * force[:, 0])
    return np.array([*force.sum(axis=0), torque])


def travel(nodes, mu, gyration_sq, speed, spin, dt=5e-4):
    """Path, sideways path and angle to rest by the equation of motion, with the midpoint rule."""
    per_mass = np.array([1.0, 1.0, 1.0 / gyration_sq])

    def rate(twist, angle):
        cosine, sine = math.cos(angle), math.sin(angle)
        turn = np.array([[cosine, sine, 0.0], [-sine, cosine, 0.0], [0.0, 0.0, 1.0]])
        return turn.T @ wrench(nodes, mu, GRAVITY, turn @ twist) * per_mass

    place, twist = np.zeros(3), np.array([speed, 0.0, spin])
    while np.hypot(np.hypot(twist[0], twist[1]), 0.05 * twist[2]) > 2e-3:
        half = twist + 0.5 * dt * rate(twist, place[2])
        twist = twist + dt * rate(half, place[2] + 0.5 * dt * twist[2])
        place = place + dt * half
    return place
