# SPDX-License-Identifier: Apache-2.0
"""How a mesh moves with the parameters of its model, as it comes from the daemon."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from remesh_client._checksum import crc32c
from remesh_client.errors import mesh_damaged
from remesh_client.v1 import motion_pb2

Floats = npt.NDArray[np.float64]
_BYTES = 8 * 3 + 1  # of a node: its velocity, and whether it has none


@dataclass(frozen=True)
class Velocity:
    """d(node)/d(parameter) of a mesh."""

    value: float  # of the parameter
    vectors: Floats  # by node of Mesh.all_points, (n, 3); length per unit of the parameter
    undefined: npt.NDArray[np.bool_]  # (n,): no velocity, for the node's faces move apart


class Derivative(float):
    """d(function)/d(parameter). undefined: how many nodes that the function depends on have no
    velocity; the derivative is reliable where it is 0."""

    undefined: int

    def __new__(cls, value: float, undefined: int = 0) -> Derivative:
        made = super().__new__(cls, value)
        made.undefined = undefined
        return made


@dataclass(frozen=True)
class Horizon:
    """The range of values of a parameter within which the connectivity is kept.
    value: now. lower, upper: ends of the range. lower_reason, upper_reason: what changes beyond
    each end, in words."""

    value: float
    lower: float
    upper: float
    lower_reason: str
    upper_reason: str


class VelocityAssembler:
    """Takes the messages of one GetDesignVelocities in their order."""

    def __init__(self) -> None:
        self._header: motion_pb2.DesignVelocityHeader | None = None
        self._data: list[bytearray] = []

    def add(self, message: motion_pb2.GetDesignVelocitiesResponse) -> None:
        """Raises MeshDamaged."""
        if message.HasField("header"):
            if self._header is not None:
                raise mesh_damaged("a second header")
            self._header = message.header
            self._data = [bytearray() for _ in message.header.parameters]
            return
        part = message.part
        if self._header is None or part.parameter >= len(self._data):
            raise mesh_damaged("a part of no parameter's velocities")
        if part.offset != len(self._data[part.parameter]):
            raise mesh_damaged("the velocities have a gap")
        if crc32c(part.data) != part.crc32c:
            raise mesh_damaged("wrong CRC-32C in a part of the velocities")
        self._data[part.parameter] += part.data

    def finish(self) -> dict[str, Velocity]:
        """By parameter. Raises MeshDamaged where they are not complete."""
        if self._header is None:
            raise mesh_damaged("the velocities have no header")
        nodes = self._header.nodes + self._header.mid_nodes
        out = {}
        for parameter, data in zip(self._header.parameters, self._data):
            if len(data) != _BYTES * nodes:
                raise mesh_damaged("the velocities are not complete")
            vectors = np.frombuffer(bytes(data), "<f8", 3 * nodes).reshape(nodes, 3)
            flags = np.frombuffer(bytes(data), np.uint8, nodes, 24 * nodes).astype(bool)
            out[parameter.name] = Velocity(parameter.value, vectors, flags)
        return out


def seed_bytes(seed: npt.ArrayLike) -> bytes:
    """d(function)/d(node) as the daemon takes it. Raises ValueError."""
    values = np.ascontiguousarray(seed, "<f8")
    if values.ndim != 2 or values.shape[1] != 3 or not np.isfinite(values).all():
        raise ValueError(f"a seed has three finite numbers for each node; this one has {values.shape}")
    return values.tobytes()


def gradient(reply: motion_pb2.GetDesignGradientResponse) -> dict[str, Derivative]:
    return {each.parameter: Derivative(each.value, each.undefined)
            for each in reply.derivatives}


def horizons(reply: motion_pb2.GetConnectivityHorizonResponse) -> dict[str, Horizon]:
    return {each.parameter: Horizon(each.value, each.lower, each.upper, each.lower_reason,
                                    each.upper_reason) for each in reply.horizons}
