# SPDX-License-Identifier: Apache-2.0
"""What decides a mesh beside its model, by the names of MeshOptions and Sizing in options.proto."""
from __future__ import annotations

import difflib
from typing import Any, Mapping, TypedDict

from remesh_client.v1 import error_pb2, options_pb2


class Options(TypedDict, total=False):
    """Options of a mesh. Left out: of a first mesh the default, of an edit what its base has.

    nodes: corner nodes aimed at, 20 or more. size: target edge length, instead of `nodes`.
    iterations: of the optimisation; 0: until quality stops improving. seed: of all random choices.
    clean_up: remove slivers. threshold: volume-length measure below which tets are cleaned up.
    inside: `membership` or `control_mesh`. start: `lattice` or `random`. order: 1 or 2.
    hold: x edge length by which surfaces may move before the connectivity changes.
    even: one edge length everywhere. edges_per_circle, layers, min_size (a length), growth: rules
    of the size field. fail_on: names of warnings that are errors, `GROUP_EMPTIED`.
    threads: for the computation; never changes the result.
    """

    nodes: int
    size: float
    iterations: int
    seed: int
    clean_up: bool
    threshold: float
    inside: str
    start: str
    order: int
    hold: float
    even: bool
    edges_per_circle: int
    layers: int
    min_size: float
    growth: float
    fail_on: list[str]
    threads: int


_SIZING = ("even", "edges_per_circle", "layers", "min_size", "growth")
_PLAIN = ("nodes", "size", "iterations", "seed", "clean_up", "threshold", "order", "hold")
_KNOWN = (*_PLAIN, *_SIZING, "inside", "start", "fail_on", "threads")


def mesh_options(options: Mapping[str, Any]) -> options_pb2.MeshOptions | None:
    """The message; None where nothing is given. Raises TypeError for an unknown name, ValueError
    for a value of another kind."""
    for name in options:
        if name not in _KNOWN:
            near = difflib.get_close_matches(name, _KNOWN, 1)
            hint = f"; is {near[0]!r} meant?" if near else f"; there are: {', '.join(_KNOWN)}"
            raise TypeError(f"no option {name!r}{hint}")
    given = {name: value for name, value in options.items() if value is not None}
    if "nodes" in given and "size" in given:
        raise TypeError("give nodes or size, not both")
    given.pop("threads", None)
    if not given:
        return None
    message = options_pb2.MeshOptions()
    for name, value in given.items():
        try:
            _put(message, name, value)
        except (TypeError, ValueError) as why:
            raise ValueError(f"the option {name}: {why}") from None
    return message


def _put(message: options_pb2.MeshOptions, name: str, value: Any) -> None:
    if name in _SIZING:
        setattr(message.sizing, name, _number(value))
    elif name == "inside":
        message.inside = options_pb2.InsideTest.Value(f"INSIDE_TEST_{_upper(value)}")
    elif name == "start":
        message.start = options_pb2.Start.Value(f"START_{_upper(value)}")
    elif name == "fail_on":
        message.fail_on.extend(error_pb2.Warning.Code.Value(code) for code in value)
    else:
        setattr(message, name, _number(value))


def _number(value: Any) -> Any:
    """numpy's scalars as Python's own, and whole floats as they are."""
    return value.item() if hasattr(value, "item") else value


def _upper(value: str) -> str:
    return str(value).upper().replace("-", "_")
