"""What the friction of a disk should be: by the kernel, by quadrature and in closed form."""

import math
import subprocess

import numpy as np

import launch


def by_kernel(mu, radius, load, speed, spin):
    """Exact force and torque from the C library."""
    words = [repr(number) for number in (mu, radius, load, speed, spin)]
    out = subprocess.run([launch.kernel(), *words], check=True, capture_output=True, text=True).stdout
    return tuple(float(word) for word in out.split())


def by_quadrature(mu, radius, load, speed, spin, points=400):
    """The integral of the local friction over the disk under uniform pressure, in polar coordinates about the centre of
    the disk. The integrand is smooth where the centre of rotation lies outside: |speed| > 1.1 |spin| radius."""
    assert abs(speed) > 1.1 * abs(spin) * radius
    nodes, weights = np.polynomial.legendre.leggauss(points)
    r = 0.5 * radius * (nodes + 1)
    angle = 2 * np.pi * np.arange(points) / points
    r, angle = np.meshgrid(r, angle, indexing="ij")
    area = np.outer(0.5 * radius * weights, np.full(points, 2 * np.pi / points)) * r
    x, y = r * np.cos(angle), r * np.sin(angle)
    vx, vy = speed - spin * y, spin * x
    local = mu * load / (np.pi * radius**2) * area / np.hypot(vx, vy)
    return -np.sum(local * vx), -np.sum(local * (x * vy - y * vx))


def by_ellipsoid(mu, radius, load, speed, spin):
    """Where the outward normal of the ellipsoid with the disk's largest force and torque is the twist."""
    force, torque = mu * load, 2 / 3 * mu * load * radius
    size = math.hypot(force * speed, torque * spin)
    return -force**2 * speed / size, -torque**2 * spin / size


def by_separate_limits(mu, radius, load, speed, spin):
    """Each at its own limit."""
    return -math.copysign(mu * load, speed), -math.copysign(2 / 3 * mu * load * radius, spin)
