# SPDX-License-Identifier: Apache-2.0
"""Plans of studies: from which revision each of many designs of one model is remeshed.

For `remesh_client.dask` and for whoever runs a study by other means, deploy/slurm among them.
"""
from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from typing import Any, Iterator, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from remesh_client.edits import Value

__all__ = ["Plan", "figures_of", "plan_designs", "tried_values", "values_in"]

_LEAST_SHARE = 0.01  # of the largest: no change is free
_FAR = 0.2  # by which a change across a parameter's whole range costs more than one nearby
_WAY = 4  # 1/_WAY of the parent's cost from the base is added to the cost of an edit
_COSTS = 1e6  # costs are compared in millionths, so that rounding decides nothing


@dataclass(frozen=True)
class Plan:
    """From which revision each design is remeshed.

    parents: of each design, the index of the one it is an edit of; -1: of the base. changes: of
    each, what that edit sets, by parameter; empty: the same values. from_base: what makes it of the
    base, where its parent failed. costs: of each edit as predicted, in the unit of the shares.
    depths: edits between the base and each. order: parents before children, branch by branch.
    """

    parents: tuple[int, ...]
    changes: tuple[dict[str, Value], ...]
    from_base: tuple[dict[str, Value], ...]
    costs: tuple[float, ...]
    depths: tuple[int, ...]
    order: tuple[int, ...]


class _Points:
    """What edits between the base, point 0, and the designs cost."""

    def __init__(self, values: Sequence[Mapping[str, Value]], shares: Mapping[str, float]) -> None:
        self._names = sorted(values[0])
        self._count = len(values)
        known = [share for share in shares.values() if share > 0] or [1.0]
        mean, least = math.fsum(known) / len(known), _LEAST_SHARE * max(known)
        self._shares = [max(shares.get(name, mean), least) for name in self._names]
        columns = [[point[name] for point in values] for name in self._names]
        self._keys = [np.unique([_key(value) for value in column], return_inverse=True)[1]
                      for column in columns]
        self._places = [_places(column) for column in columns]

    def costs(self, point: int) -> npt.NDArray[np.int64]:
        """Of the edits from one to each, in millionths."""
        total = np.zeros(self._count)
        for share, keys, places in zip(self._shares, self._keys, self._places):
            distance = np.abs(places - places[point])
            distance[np.isnan(distance)] = 1.0
            total += np.where(keys == keys[point], 0.0, share * (1.0 + _FAR * distance))
        return (_COSTS * total).round().astype(np.int64)


def plan_designs(base: Mapping[str, Value], designs: Sequence[Mapping[str, Value]], *,
                 depth: int = 8, shares: Mapping[str, float] | None = None) -> Plan:
    """A tree of low predicted cost, in which no design is more than `depth` edits from the base.

    base: its values of all parameters that designs set. designs: values by parameter; what one
    leaves out is the base's. depth: 1: all from the base. shares: by parameter what its change
    costs, as a share of the mesh that it makes anew; only ratios count; left out: alike.

    An edit costs the sum of the shares of what it changes, each up to a fifth more with the
    distance within that parameter's range. What every edit costs beside is the same for all trees.
    A chain is made one edit after another, so a minimum spanning tree alone would keep workers
    waiting: a design takes a parent further from the base where that saves more than a quarter of
    the way there. Raises KeyError for a parameter that the base has not, ValueError for a depth
    below 1.

    Source: the Prim-Dijkstra trade-off, Alpert, Hu, Huang, Kahng and Karger 1995.
    """
    if depth < 1:
        raise ValueError("a design is at least one edit from the base: depth >= 1")
    full = [dict(base)] + [{**base, **_known(design, base)} for design in designs]
    points = _Points(full, shares or {})
    count = len(full)
    parent, depths, ways = np.zeros((3, count), np.int64)
    costs = points.costs(0)
    keys, left = costs.copy(), np.arange(count) > 0
    for _ in designs:
        point = int(np.argmin(np.where(left, keys, np.iinfo(np.int64).max)))
        left[point] = False
        depths[point] = depths[parent[point]] + (costs[point] > 0)
        ways[point] = ways[parent[point]] + costs[point]
        found = points.costs(point)
        reached = found + ways[point] // _WAY
        nearer = left & (reached < keys) & ((found == 0) | (depths[point] < depth))
        keys[nearer], costs[nearer], parent[nearer] = reached[nearer], found[nearer], point
    return Plan(tuple(int(above) - 1 for above in parent[1:]),
                tuple(_changes(full[parent[point]], full[point]) for point in range(1, count)),
                tuple(_changes(full[0], values) for values in full[1:]),
                tuple(float(each) / _COSTS for each in costs[1:]),
                tuple(int(each) for each in depths[1:]),
                tuple(_branch_by_branch(parent)))


def _known(design: Mapping[str, Value], base: Mapping[str, Value]) -> Mapping[str, Value]:
    for name in design:
        if name not in base:
            raise KeyError(f"the base has no parameter {name!r}")
    return design


def _changes(old: Mapping[str, Value], new: Mapping[str, Value]) -> dict[str, Value]:
    return {name: new[name] for name in sorted(new) if _key(old[name]) != _key(new[name])}


def _key(value: Value) -> str:
    """Equal for equal values; 4 and 4.0 are."""
    return repr(value) if isinstance(value, str) else repr(float(value))


def _places(column: Sequence[Value]) -> npt.NDArray[np.float64]:
    """From 0 to 1 within the parameter's range; NaN for expressions."""
    places = np.array([np.nan if isinstance(value, str) else float(value) for value in column])
    numbers = places[~np.isnan(places)]
    extent = np.ptp(numbers) if len(numbers) else 0.0
    if extent > 0:
        places = (places - numbers.min()) / extent
    return places


def _branch_by_branch(parent: npt.NDArray[np.int64]) -> Iterator[int]:
    """Designs, each followed by all that are made of it. parent: of points; the base is 0."""
    children: dict[int, list[int]] = {}
    for point in range(len(parent) - 1, 0, -1):
        children.setdefault(int(parent[point]), []).append(point)
    ahead = children.get(0, [])
    while ahead:
        point = ahead.pop()
        yield point - 1
        ahead += children.get(point, [])


def tried_values(base: Mapping[str, Value],
                  designs: Sequence[Mapping[str, Value]]) -> list[dict[str, Value]]:
    """For each parameter that varies, the value other than the base's that most designs have."""
    tried = []
    for name in sorted(base):
        others = {_key(design[name]): design[name] for design in designs
                  if name in design and _key(design[name]) != _key(base[name])}
        counts = Counter(_key(design[name]) for design in designs if name in design)
        if others:
            tried.append({name: others[max(others, key=lambda key: counts[key])]})
    return tried


def values_in(document: Mapping[str, Any], names: Sequence[str]) -> dict[str, Value]:
    """Values in a model's document of parameters, of the model or of features (`rib.width`).

    Raises KeyError for one that it has not.
    """
    features = {feature["id"]: feature for feature in document["features"]}
    values: dict[str, Value] = {}
    for name in names:
        feature, dot, parameter = name.rpartition(".")
        owner = features.get(feature, {}) if dot else document
        found = owner.get("parameters", {}).get(parameter)
        if found is None:
            raise KeyError(f"the base has no parameter {name!r}")
        values[name] = found["value"] if isinstance(found, Mapping) else found
    return values


def figures_of(message: Any, prefix: str = "") -> dict[str, float]:
    """The scalar numbers (double, uint32) of a message, a Report, by name; those of a nested
    message as `seconds.total`. Lists and `diagnostics` are left out."""
    figures: dict[str, float] = {}
    for field in message.DESCRIPTOR.fields:
        value = getattr(message, field.name)
        if field.label == field.LABEL_REPEATED or field.name == "diagnostics":
            continue
        if field.cpp_type == field.CPPTYPE_MESSAGE:
            figures |= figures_of(value, f"{prefix}{field.name}.")
        elif field.cpp_type in (field.CPPTYPE_DOUBLE, field.CPPTYPE_UINT32):
            figures[prefix + field.name] = value
    return figures
