# SPDX-License-Identifier: Apache-2.0
"""Client of remeshd: tetrahedral meshes of feature models, remeshed after each edit.

    import remesh_client as rc
    with rc.connect() as daemon:
        part = daemon.mesh("bracket.json", nodes=8000)
        for radius in (8, 8.5, 9):
            part = part.edit(hole_radius=radius)
            mesh = part.mesh()          # .points .tets .faces["hole.wall"].nodes .parent_nodes
            print(part.report.nodes_kept, part.warnings, mesh.write("b.inp"))
"""
import importlib
from types import ModuleType

from remesh_client import adjoint, calculix
from remesh_client._motion import Derivative, Horizon, Velocity
from remesh_client.daemon import Daemon, connect, local
from remesh_client.edits import (Edit, add, place, remove, remove_group, remove_size, set_group,
                                 set_parameter, set_size)
from remesh_client.errors import (Busy, Cancelled, Conflict, DeadlineExceeded, Denied,
                                  InvalidRequest, MeshDamaged, MeshingFailed, NotFound,
                                  RemeshError, Unavailable, Unsupported)
from remesh_client.mesh import Mesh, NodeSet
from remesh_client.options import Options
from remesh_client.part import Part, Warning
from remesh_client.transfer import transfer

__version__ = "0.1.0"
__all__ = ["Busy", "Cancelled", "Conflict", "Daemon", "DeadlineExceeded", "Denied", "Derivative",
           "Edit", "Horizon", "InvalidRequest", "Mesh", "MeshDamaged", "MeshingFailed", "NodeSet", "NotFound",
           "Options", "Part", "RemeshError", "Unavailable", "Unsupported", "Velocity", "Warning",
           "add", "adjoint", "calculix", "connect", "local", "place", "remove", "remove_group", "remove_size", "set_group",
           "set_parameter", "set_size", "transfer"]


def __getattr__(name: str) -> ModuleType:
    """`rc.aio` and `rc.openmdao`, imported when they are first asked for."""
    if name in ("aio", "openmdao"):
        return importlib.import_module(f"remesh_client.{name}")
    raise AttributeError(f"module 'remesh_client' has no attribute {name!r}")
