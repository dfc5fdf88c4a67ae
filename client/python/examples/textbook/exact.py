# SPDX-License-Identifier: Apache-2.0
"""Closed solutions of linear elasticity in three dimensions.

Each has displacement(points) and stress(points), points (k, 3): (k, 3), and (k, 6) in the order
xx yy zz xy yz zx; and traction(points, normals), (k, 3), the force by area on such a surface.
"""
from dataclasses import dataclass

import numpy as np

_TERMS = 40  # of the flexure's series; the rest is 2e-4 of the greatest stress, at corners


@dataclass(frozen=True)
class Solution:
    """What the solutions share: the material, and tractions from stresses."""

    young: float
    poisson: float

    @property
    def shear(self):
        return self.young / (2 * (1 + self.poisson))

    def traction(self, points, normals):
        xx, yy, zz, xy, yz, zx = self.stress(points).T
        x, y, z = normals.T
        return np.column_stack([xx * x + xy * y + zx * z, xy * x + yy * y + yz * z,
                                zx * x + yz * y + zz * z])


@dataclass(frozen=True)
class Flexure(Solution):
    """A bar of rectangular section along x, bent along z by a force at its end: Saint-Venant's.

    |y| <= half_width, |z| <= half_depth, 0 <= x <= length. Its long sides are free of stress for
    any Poisson's ratio, sections warp freely, and the force is spread over the end as the shear
    stress of any other section is. At x = 0 the mean displacement is nought and so is the mean
    rotation, integral of z u_x by the second moment; the mean displacement of the end is then that
    of Timoshenko's beam with Cowper's coefficient. Source: Love, Mathematical Theory of Elasticity,
    chapter XV; Cowper, J. Appl. Mech. 33 (1966).
    """

    length: float
    half_width: float
    half_depth: float
    force: float

    @property
    def second_moment(self):
        return 4 / 3 * self.half_width * self.half_depth**3

    @property
    def timoshenko(self):
        """The end's displacement by beam theory."""
        area = 4 * self.half_width * self.half_depth
        shear = 10 * (1 + self.poisson) / (12 + 11 * self.poisson) * self.shear * area
        bending = self.young * self.second_moment
        return self.force * (self.length**3 / (3 * bending) + self.length / shear)

    def displacement(self, points):
        lift, turn = self._clamp()
        x, y, z = points.T
        move = self._free(points)
        return move + np.column_stack([-turn * z, 0 * y, turn * x - lift])

    def stress(self, points):
        x, y, z = points.T
        nu = self.poisson
        by_y, by_z = self._warping(y, z)[1:]
        scale = self.force / (2 * (1 + nu) * self.second_moment)
        zero = np.zeros_like(x)
        return np.column_stack([
            -self.force * (self.length - x) * z / self.second_moment, zero, zero,
            -scale * (by_y + (2 + nu) * y * z), zero,
            -scale * (by_z + nu / 2 * z**2 + (1 - nu / 2) * y**2)])

    def _free(self, points):
        """The displacement but for a rigid motion."""
        x, y, z = points.T
        nu, left = self.poisson, self.length - x
        warping = self._warping(y, z)[0]
        return self.force / (self.young * self.second_moment) * np.column_stack([
            -z * (self.length * x - x**2 / 2) - warping - z * y**2, nu * left * y * z,
            nu / 2 * left * (z**2 - y**2) + self.length * x**2 / 2 - x**3 / 6])

    def _clamp(self):
        """Mean displacement along z and mean rotation of `_free` at x = 0."""
        places, weights = np.polynomial.legendre.leggauss(40)
        y, z = (grid.ravel() for grid in np.meshgrid(self.half_width * places,
                                                     self.half_depth * places))
        weights = np.outer(weights, weights).ravel() / 4
        move = self._free(np.column_stack([0 * y, y, z]))
        return weights @ move[:, 2], weights @ (z * move[:, 0]) / (weights @ z**2)

    def _warping(self, y, z):
        """Love's flexure function, harmonic, and its derivatives by y and z."""
        nu, a, b = self.poisson, self.half_depth, self.half_width
        slope = -(1 + nu) * a**2 + nu * b**2 / 3
        value = slope * z - (2 + nu) * (z * y**2 / 2 - z**3 / 6)
        by_y = -(2 + nu) * y * z
        by_z = slope - (2 + nu) * (y**2 - z**2) / 2
        for n in range(1, _TERMS + 1):
            k = n * np.pi / b
            near, far = np.exp(-k * (a - z)), np.exp(-k * (a + z))
            factor = 4 * nu * b**3 * (-1)**n / ((n * np.pi)**3 * (1 + np.exp(-2 * k * a)))
            value += factor * (near - far) * np.cos(k * y)
            by_y -= k * factor * (near - far) * np.sin(k * y)
            by_z += k * factor * (near + far) * np.cos(k * y)
        return value, by_y, by_z


@dataclass(frozen=True)
class PlaneStrain(Solution):
    """Solutions that do not depend on z, with u_z = 0."""

    def _stress(self, xx, yy, xy):
        zero = np.zeros_like(xx)
        return np.column_stack([xx, yy, self.poisson * (xx + yy), xy, zero, zero])


@dataclass(frozen=True)
class Hole(PlaneStrain):
    """An infinite plate with a hole about the z axis, drawn along x: Kirsch's."""

    radius: float
    tension: float

    def displacement(self, points):
        x, y, _ = points.T
        r, angle = np.hypot(x, y) / self.radius, np.arctan2(y, x)
        kappa = 3 - 4 * self.poisson
        cube = 2 / r - 2 / r**3
        scale = self.tension * self.radius / (8 * self.shear)
        along = (r * (kappa + 1) + 2 / r * (1 + kappa)) * np.cos(angle) + cube * np.cos(3 * angle)
        across = (r * (kappa - 3) + 2 / r * (1 - kappa)) * np.sin(angle) + cube * np.sin(3 * angle)
        return scale * np.column_stack([along, across, 0 * x])

    def stress(self, points):
        x, y, _ = points.T
        square, angle = self.radius**2 / (x**2 + y**2), np.arctan2(y, x)
        two, four = np.cos(2 * angle), np.cos(4 * angle)
        fourth = 1.5 * square**2
        return self.tension * self._stress(
            1 - square * (1.5 * two + four) + fourth * four,
            -square * (.5 * two - four) - fourth * four,
            -square * (.5 * np.sin(2 * angle) + np.sin(4 * angle)) + fourth * np.sin(4 * angle))


@dataclass(frozen=True)
class Tube(PlaneStrain):
    """A thick cylinder about the z axis under pressure from inside: Lamé's."""

    inner: float
    outer: float
    pressure: float

    def displacement(self, points):
        x, y, _ = points.T
        even, falling = self._parts(x, y)
        factor = ((1 - 2 * self.poisson) * even + falling) / (2 * self.shear)
        return np.column_stack([factor * x, factor * y, 0 * x])

    def stress(self, points):
        x, y, _ = points.T
        even, falling = self._parts(x, y)
        square = x**2 + y**2
        radial = falling * (x**2 - y**2) / square
        return self._stress(even - radial, even + radial, -2 * falling * x * y / square)

    def _parts(self, x, y):
        """The mean of radial and hoop stress, and half of what they differ by."""
        even = self.pressure * self.inner**2 / (self.outer**2 - self.inner**2)
        return even, even * self.outer**2 / (x**2 + y**2)
