# SPDX-License-Identifier: Apache-2.0
"""A revision of a model, and the next ones made of it."""
from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Mapping

import numpy.typing as npt

from remesh_client._assembler import Content
from remesh_client._exchange import Exchange, OnProgress
from remesh_client._motion import Derivative, Horizon, Velocity
from remesh_client._requests import edit_of
from remesh_client.edits import EditLike
from remesh_client.errors import Point
from remesh_client.mesh import Mesh, WriteFile
from remesh_client.v1 import error_pb2, report_pb2, revision_pb2

if TYPE_CHECKING:
    from remesh_client.daemon import Daemon


@dataclass(frozen=True)
class Warning:
    """A result that is valid, yet not what its reader may think.

    code: `GROUP_EMPTIED`, `CHORDS_COARSE`, ... (error.proto). features, groups: names. point: x y
    z in the model's unit. nodes_needed: corner nodes that resolve all details, else 0.
    """

    code: str
    message: str
    features: tuple[str, ...] = ()
    groups: tuple[str, ...] = ()
    point: Point | None = None
    nodes_needed: int = 0

    def __str__(self) -> str:
        return f"{self.code}: {self.message}"

    __repr__ = __str__


def in_several(revision: str, reply: revision_pb2.GetRevisionResponse) -> bool:
    """Whether a revision was asked for by an id, and is in several designs."""
    named = revision.rpartition("@")[0] or revision
    return len(reply.places) > 1 and named != reply.revision.design


def warning_of(message: error_pb2.Warning) -> Warning:
    """The warning of a message; a code that is not known yet keeps its number."""
    try:
        code = error_pb2.Warning.Code.Name(message.code).removeprefix("CODE_")
    except ValueError:
        code = str(message.code)
    point = tuple(message.point)
    return Warning(code, message.message, tuple(message.features), tuple(message.groups),
                   (point[0], point[1], point[2]) if len(point) == 3 else None,
                   message.nodes_needed)


class Revision:
    """What a Part tells of its revision.

    revision: id. design, number: its place in a design; empty and 0 in none, and where it was
    opened by an id that is in several. report: a Report (report.proto), `report.nodes_kept`,
    `report.seconds.total`. durable: it survives the daemon.
    head_conflict: the design's head was another one by then and stayed. warnings: what the report
    warns of.
    """

    def __init__(self, info: revision_pb2.RevisionInfo, report: report_pb2.Report,
                 exchange: Exchange | None, durable: bool, head_conflict: bool,
                 in_several: bool) -> None:
        self._exchange = exchange  # that brings the mesh, until it has
        self._mesh: Mesh | None = None
        self.revision: str = info.id
        self.parent: str = info.parent
        self._in_several = in_several
        self.design: str = "" if in_several else info.design
        self.number: int = 0 if in_several else info.number
        self.report = report
        self.durable = durable
        self.head_conflict = head_conflict
        self.warnings: list[Warning] = [warning_of(warning) for warning in report.warnings]

    def _content(self) -> Content | None:
        """The arrays of its mesh, once they have come."""
        if self._mesh is not None:
            return self._mesh.content
        return self._exchange.mesh if self._exchange is not None else None

    def _areas(self) -> dict[str, float]:
        """Exact areas of groups, where the daemon knows them."""
        return {audit.group: audit.exact_area for audit in self.report.groups
                if audit.exact_area > 0}

    def _keep(self, content: Content, write_file: WriteFile | None = None) -> Mesh:
        """The mesh of these arrays, which it has from now on."""
        self._mesh = Mesh(content, write_file, self._areas())
        self._exchange = None
        return self._mesh

    def _base(self) -> Callable[[], Content | None] | None:
        """What a delta may be against; None where its mesh neither is here nor comes."""
        comes = (self._exchange is not None and self._exchange.mesh_error is None
                 and self._exchange.request.HasField("mesh"))
        return self._content if self._mesh is not None or comes else None

    def _design_of(self, file: bool | None) -> str:
        """What an edit names: the base is an id, which may be in other designs too."""
        return "" if file is False else self.design

    def _filed(self, file: bool | None) -> bool | None:
        """Whether an edit is filed; what is made of a revision in no design is in none."""
        return False if file is None and not (self.design or self._in_several) else file

    def __repr__(self) -> str:
        name = f"{self.design}@{self.number} " if self.design else ""
        return (f"<{type(self).__name__} {name}{self.revision[:12]}: {self.report.nodes} nodes, "
                f"{self.report.nodes_kept} kept>")


class Part(Revision):
    """A meshed model. It never changes: an edit gives another one."""

    def __init__(self, daemon: Daemon, info: revision_pb2.RevisionInfo, report: report_pb2.Report,
                 exchange: Exchange | None = None, durable: bool = False,
                 head_conflict: bool = False, route: str | None = None,
                 in_several: bool = False) -> None:
        super().__init__(info, report, exchange, durable, head_conflict, in_several)
        self._daemon = daemon
        self._route: str = route or info.design or info.root

    def edit(self, *edits: EditLike, options: Mapping[str, Any] | None = None, mesh: bool = True,
             file: bool | None = None, progress: OnProgress | None = None,
             timeout: float | None = None, **parameters: Any) -> Part:
        """The model after edits, remeshed; most of its mesh is this one's, bit for bit.

        edits: `{"hole.radius": 8}`, `rc.remove("rib")`, a document (a mapping or a path to a
        file), or a list of such. parameters: of the model, by name; one with the name of an
        argument, or with a dot, stands in a mapping. options: as rc.Options; left out, those of
        this part hold. mesh: has the mesh come along, as a difference to this one's. file: False:
        in no design; the design's head stays. Left out: in this part's design, or in none as it
        is. progress: called with each Progress (stage, iteration, fraction) while this waits.
        timeout: s.

        Raises RemeshError; OSError, ValueError and TypeError for what cannot be sent.
        KeyboardInterrupt cancels the computation.
        """
        return self._daemon._make(edit_of(
            self.revision, edits, parameters, options or {}, self._filed(file), mesh, self._base(),
            progress, self._route, self._design_of(file)), timeout)

    def mesh(self) -> Mesh:
        """Its mesh; the same object each time. Raises RemeshError."""
        if self._mesh is None:
            if self._exchange is not None and self._exchange.carrier is not None:
                self._exchange.carrier.wait(self._exchange, lambda exchange: exchange.done)
            content = self._content()
            if content is None:  # not asked for, or damaged on its way
                content = self._daemon._fetch(self.revision, self._route)
            return self._keep(content, self._write_file)
        return self._mesh

    def write(self, path: os.PathLike[str] | str) -> Path:
        """As Mesh.write, without the mesh coming here."""
        return self._write_file(self.revision, path)

    def velocities(self, *parameters: str) -> dict[str, Velocity]:
        """d(node)/d(parameter) of its mesh, by parameter.
        parameters: names of parameters of the model, `radius`, or of a feature, `hole.radius`, at
        most 100; default: all of the model that are not integers. Raises RemeshError."""
        return self._daemon._velocities(self.revision, parameters, self._route)

    def gradient(self, seed: npt.ArrayLike, *parameters: str) -> dict[str, Derivative]:
        """From d(function)/d(node), (n, 3) by node of Mesh.all_points, to d(function)/d(parameter).

        parameters: as of `velocities`. Raises RemeshError; ValueError for a seed of another shape.
        """
        return self._daemon._gradient(self.revision, seed, parameters, self._route)

    def horizon(self, *parameters: str, hold: float | None = None) -> dict[str, Horizon]:
        """How far each parameter may go, alone, before the connectivity changes.

        parameters: as of `velocities`. hold: as rc.Options; default: this part's. Every value tried
        is meshed and verified, so it takes some dozen edits' time. Raises RemeshError.
        """
        return self._daemon._horizon(self.revision, parameters, hold, self._route)

    def document(self) -> dict[str, Any]:
        """The model, as a document; expressions as written."""
        return self._daemon._document(self.revision, self._route)

    def _write_file(self, revision: str, path: os.PathLike[str] | str) -> Path:
        return self._daemon._write_file(revision, path, self._route)
