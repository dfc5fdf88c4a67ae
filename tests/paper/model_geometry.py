"""Where the edges and vertices of a case's model lie, worked out from its document alone.

An evaluator beside the engine: it shares no code and no method with it. A feature is an
intersection of half-spaces and solid cylinders (blocks, cylinders, convex prisms: what the paper's
cases use), an edge is where two surfaces meet and the material round the point fills neither a
half-space, all, nor nothing.
"""
import itertools
import json
import math
from pathlib import Path

import numpy as np


class Plane:
    """The side n.(p - o) <= 0."""

    def __init__(self, origin, normal):
        self.origin, self.normal = np.asarray(origin, float), np.asarray(normal, float)

    def distance(self, points):
        return (points - self.origin) @ self.normal

    def same(self, other, tolerance):
        return (isinstance(other, Plane) and abs(abs(self.normal @ other.normal) - 1) < 1e-12
                and abs(self.distance(other.origin)) < tolerance)


class Cylinder:
    """The inside of an endless cylinder."""

    def __init__(self, origin, axis, radius):
        self.origin, self.axis, self.radius = np.asarray(origin, float), np.asarray(axis, float), radius

    def distance(self, points):
        d = points - self.origin
        return np.linalg.norm(d - np.outer(d @ self.axis, self.axis), axis=-1) - self.radius

    def same(self, other, tolerance):
        return (isinstance(other, Cylinder) and abs(abs(self.axis @ other.axis) - 1) < 1e-12
                and abs(self.radius - other.radius) < tolerance
                and np.linalg.norm(np.cross(other.origin - self.origin, self.axis)) < tolerance)

    def generators(self, count):
        """Points on a circle; through each runs a straight line along the axis."""
        x = np.cross(self.axis, [0, 1, 0] if abs(self.axis[0]) > .6 else [1, 0, 0])
        x /= np.linalg.norm(x)
        y = np.cross(self.axis, x)
        t = 2 * math.pi * np.arange(count) / count
        return self.origin + self.radius * (np.outer(np.cos(t), x) + np.outer(np.sin(t), y))


def line_hits(surface, points, direction):
    """Where the lines points + s * direction meet the surface: arrays of s, NaN where they do not."""
    if isinstance(surface, Plane):
        slope = surface.normal @ direction
        return [-surface.distance(points) / slope] if abs(slope) > 1e-12 else []
    flat = lambda v: v - np.multiply.outer(v @ surface.axis, surface.axis)
    d, o = flat(direction), flat(points - surface.origin)
    a, b, c = d @ d, o @ d, (o * o).sum(-1) - surface.radius ** 2
    if a < 1e-20:
        return []
    with np.errstate(invalid="ignore"):
        root = np.sqrt(np.where(b * b >= a * c, b * b - a * c, np.nan))
    return [(-b - root) / a, (-b + root) / a]


class Model:
    """A model document of blocks, cylinders and convex prisms."""

    def __init__(self, path):
        document = json.loads(Path(path).read_text(encoding="utf-8"))
        names = {k: getattr(math, k) for k in ("sin", "cos", "tan", "sqrt")} | {
            "pi": math.pi, "deg": math.pi / 180} | document.get("parameters", {})
        value = lambda v: float(eval(v, {"__builtins__": {}}, names)) if isinstance(v, str) else float(v)
        self.features = [(f["nature"] == "ADDITIVE", _surfaces(f, value)) for f in document["features"]]
        every = [s for _, surfaces in self.features for s in surfaces]
        points = np.array([s.origin for s in every])
        self.diagonal = float(np.linalg.norm(points.max(0) - points.min(0)))
        self.probe = 1e-4 * self.diagonal  # radius of what counts as round a point
        self.surfaces = []
        for s in every:
            if not any(s.same(t, 1e-9 * self.diagonal) for t in self.surfaces):
                self.surfaces.append(s)

    def inside(self, points):
        """Whether each point lies in material: the last feature that contains it decides."""
        result = np.zeros(len(points), bool)
        for additive, surfaces in self.features:
            result[np.all([s.distance(points) <= 0 for s in surfaces], axis=0)] = additive
        return result

    def is_sharp(self, points):
        """Whether the boundary is neither absent nor smooth at each point."""
        if len(points) == 0:
            return np.zeros(0, bool)
        i = np.arange(400) + .5  # directions spread evenly over the sphere
        z, t = 1 - 2 * i / 400, math.pi * (1 + 5 ** .5) * i
        directions = np.stack([np.cos(t) * np.sqrt(1 - z * z), np.sin(t) * np.sqrt(1 - z * z), z], 1)
        around = points[:, None, :] + self.probe * directions
        filled = self.inside(around.reshape(-1, 3)).reshape(len(points), -1)
        towards = filled @ directions
        towards /= np.maximum(np.linalg.norm(towards, axis=1), 1e-300)[:, None]
        half = towards @ directions.T > 0
        mixed = filled.any(1) & ~filled.all(1)
        return mixed & ((filled != half).mean(1) > .03)

    def edges(self, spacing):
        """(surface, surface, points) for every pair of surfaces that meets in model edges, with
        points on these about `spacing` apart."""
        for a, b in itertools.combinations(self.surfaces, 2):
            points = self._curve(a, b, spacing)
            points = points[self.is_sharp(points)]
            if len(points):
                # Where the curve only crosses an edge of other surfaces it is sharp to neither side.
                along = np.cross(_normal(a, points), _normal(b, points))
                along *= 3 * self.probe / np.linalg.norm(along, axis=1)[:, None]
                points = points[self.is_sharp(points + along) | self.is_sharp(points - along)]
            if len(points):
                yield a, b, points

    def vertices(self):
        """Points where model edges end or bend: those where three surfaces meet and the edges
        that leave the point are not two halves of one smooth curve."""
        found = []
        for a, b, c in itertools.combinations(self.surfaces, 3):
            for p in self._meetings(a, b, c):
                if self._is_vertex(p) and not any(np.linalg.norm(p - q) < 1e-7 * self.diagonal for q in found):
                    found.append(p)
        return np.array(found).reshape(-1, 3)

    def _curve(self, a, b, spacing):
        if isinstance(b, Cylinder):
            a, b = b, a
        if isinstance(a, Cylinder):
            start = a.generators(max(16, math.ceil(2 * math.pi * a.radius / spacing)))
            hits = line_hits(b, start, a.axis)
            if hits:
                points = np.vstack([start + np.outer(s, a.axis) for s in hits])
                return self._within(points[np.isfinite(points).all(1)])
            if isinstance(b, Cylinder):  # parallel: none of the cases has them meet
                return np.zeros((0, 3))
            across = np.cross(a.axis, b.normal)
            foot = a.origin - b.distance(a.origin) * b.normal
            starts = [foot + s * across for s in line_hits(a, foot, across)[0:2] if np.isfinite(s)]
            direction = a.axis
        else:
            direction = np.cross(a.normal, b.normal)
            if np.linalg.norm(direction) < 1e-9:
                return np.zeros((0, 3))
            rows = np.array([a.normal, b.normal, direction])
            starts = [np.linalg.solve(rows, [a.normal @ a.origin, b.normal @ b.origin, 0])]
        direction = direction / np.linalg.norm(direction)
        steps = np.arange(-3 * self.diagonal, 3 * self.diagonal, spacing) + .37 * spacing
        return self._within(np.vstack([p + np.outer(steps, direction) for p in starts])
                            if starts else np.zeros((0, 3)))

    def _within(self, points):
        """Those on the closed boundary box of some feature: all that an edge may touch."""
        keep = np.zeros(len(points), bool)
        for _, surfaces in self.features:
            keep |= np.all([s.distance(points) <= 1e-7 * self.diagonal for s in surfaces], axis=0)
        return points[keep]

    def _meetings(self, a, b, c):
        """Points on all three surfaces, by Newton's method from the curves of two of them."""
        found, step = [], self.diagonal / 40
        starts = self._curve(a, b, step)
        for start in starts[abs(c.distance(starts)) < step]:
            p = start
            for _ in range(30):
                f = np.array([s.distance(p[None])[0] for s in (a, b, c)])
                jacobian = np.array([_normal(s, p) for s in (a, b, c)])
                if abs(np.linalg.det(jacobian)) < 1e-6:
                    break
                move = np.linalg.solve(jacobian, f)
                p = p - move
                if np.linalg.norm(move) < 1e-13 * self.diagonal:
                    if np.linalg.norm(p - start) < 4 * step and not any(
                            np.linalg.norm(p - q) < 1e-7 * self.diagonal for q in found):
                        found.append(p)
                    break
        return found

    def _is_vertex(self, p):
        """Follows every pair of surfaces through p a little way to both sides."""
        through = [s for s in self.surfaces if abs(s.distance(p[None])[0]) < 1e-8 * self.diagonal]
        branches = []
        for a, b in itertools.combinations(through, 2):
            along = np.cross(_normal(a, p), _normal(b, p))
            if np.linalg.norm(along) < 1e-9:
                continue
            along /= np.linalg.norm(along)
            for direction in (along, -along):
                q = p + 1e-3 * self.diagonal * direction
                for _ in range(20):  # back onto both surfaces
                    for s in (a, b):
                        q = q - s.distance(q[None])[0] * _normal(s, q)
                if self.is_sharp(q[None])[0] and not any(direction @ d > .9999 for d in branches):
                    branches.append(direction)
        return len(branches) > 2 or (len(branches) == 2 and branches[0] @ branches[1] > -.9999)


def _normal(surface, p):
    """Unit normal at a point or at each of several."""
    if isinstance(surface, Plane):
        return np.broadcast_to(surface.normal, p.shape)
    d = p - surface.origin
    d = d - np.multiply.outer(d @ surface.axis, surface.axis)
    return d / np.linalg.norm(d, axis=-1, keepdims=True)


def _surfaces(feature, value):
    """The half-spaces and cylinders whose intersection the feature is."""
    number = {k: value(v) for k, v in feature["parameters"].items() if k != "profile"}
    placement = feature.get("placement", {})
    origin = np.array([value(v) for v in placement.get("origin", [0, 0, 0])])
    z = np.array([value(v) for v in placement.get("zAxis", [0, 0, 1])])
    z /= np.linalg.norm(z)
    x = np.array([value(v) for v in placement.get("xAxis", [0, 1, 0] if abs(z[0]) == 1 else [1, 0, 0])])
    x = x - (x @ z) * z
    x /= np.linalg.norm(x)
    y = np.cross(z, x)
    if feature["type"] == "block":
        dx, dy, dz = (number[k] for k in ("dx", "dy", "dz"))
        sides = [Plane(origin + s * d / 2 * n, s * n) for d, n in ((dx, x), (dy, y)) for s in (-1, 1)]
        height = dz
    elif feature["type"] == "cylinder":
        sides, height = [Cylinder(origin, z, number["radius"])], number["height"]
    elif feature["type"] == "prism":
        corners = [[value(c) for c in corner] for corner in feature["parameters"]["profile"]]
        turn = sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(corners, corners[1:] + corners[:1]))
        sides, height = [], number["height"]
        for p, q in zip(corners, corners[1:] + corners[:1]):
            n = np.sign(turn) * ((q[1] - p[1]) * x - (q[0] - p[0]) * y)
            sides.append(Plane(origin + p[0] * x + p[1] * y, n / np.linalg.norm(n)))
        world = np.array([origin + p[0] * x + p[1] * y for p in corners])
        if any(s.distance(world).max() > 1e-9 for s in sides):
            raise NotImplementedError(f"{feature['id']}: a prism that is not convex")
    else:
        raise NotImplementedError(f"{feature['id']}: type {feature['type']}")
    return sides + [Plane(origin, -z), Plane(origin + height * z, z)]
