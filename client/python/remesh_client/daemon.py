# SPDX-License-Identifier: Apache-2.0
"""A connection to a daemon."""
from __future__ import annotations

import json
import os
import time
from pathlib import Path
from types import TracebackType
from typing import Any, Callable, Iterable, Iterator, Sequence, TypeVar

import grpc
import numpy.typing as npt

from remesh_client import _requests
from remesh_client._answers import messages
from remesh_client._assembler import Content, MeshAssembler
from remesh_client._connection import Access, addresses_or_default
from remesh_client._exchange import Exchange, OnProgress, is_broken, was_answered
from remesh_client._farm import Farm, Replica
from remesh_client._files import FileAssembler, write_whole
from remesh_client._motion import (Derivative, Horizon, Velocity, VelocityAssembler, gradient,
                                   horizons, seed_bytes)
from remesh_client._search import PATIENCE, Search, route_of
from remesh_client.edits import Model
from remesh_client.errors import Error, from_rpc, made_here
from remesh_client.local import LocalDaemon
from remesh_client.options import mesh_options
from remesh_client.part import Part, in_several
from remesh_client.v1 import mesh_pb2, model_pb2, motion_pb2, revision_pb2, server_pb2

T = TypeVar("T")


class Daemon:
    """Made by `connect` or `local`; a context manager. May be used by several threads.

    Requests of one Daemon go through one EditStream and are answered in their order.
    """

    def __init__(self, addresses: Sequence[str], access: Access = Access(),
                 local: LocalDaemon | None = None, patience: float = PATIENCE) -> None:
        self.address = ",".join(addresses)
        self._local = local
        self._farm = Farm(addresses, access, patience)

    def mesh(self, model: Model, *, design: str = "", file: bool | None = None,
             with_mesh: bool = True, progress: OnProgress | None = None,
             timeout: float | None = None, route: str | None = None, **options: Any) -> Part:
        """Meshes a model; the same request again is answered from the daemon's cache.

        model: a path to a JSON document, a mapping as in one, or a FeatureModel. design: the name
        of the list of revisions that it joins; default: the model's. file: False: in none.
        with_mesh: has the mesh come along. progress: called with each Progress (stage, iteration,
        fraction) while this waits. timeout: s. route: where there are several daemons, requests of
        the same route go to the same one; default: the design, or for a first mesh in no design a
        digest of the request. options: as rc.Options, `nodes=8000, order=2`.

        Raises RemeshError; OSError, ValueError and TypeError for what cannot be sent.
        KeyboardInterrupt cancels the computation.
        """
        return self._make(_requests.first_mesh(model, options, design, file, with_mesh, progress,
                                               route), timeout)

    def open(self, revision: str) -> Part:
        """A revision that is there: a design (its head), `design@number`, an id or 8 digits of
        it. Edits of one that an id names and several designs have are refused with their names,
        unless they are filed in none, or the last edit was in one of these. Raises NotFound."""
        reply = self._ask("GetRevision", revision_pb2.GetRevisionRequest(revision=revision),
                          route_of(revision))
        return Part(self, reply.revision, reply.report, durable=reply.durable,
                    in_several=in_several(revision, reply))

    def validate(self, model: Model, **options: Any) -> model_pb2.ModelCheck:
        """Checks a model without meshing it: a ModelCheck with what its mesh would come to."""
        request = model_pb2.ValidateModelRequest(options=mesh_options(options))
        _requests.put_model(request, model)
        check: model_pb2.ModelCheck = self._ask("ValidateModel", request).check
        return check

    def log(self, design: str) -> list[revision_pb2.RevisionInfo]:
        """The revisions of a design by number. Raises NotFound."""
        request = revision_pb2.ListRevisionsRequest(
            filter=revision_pb2.RevisionFilter(design=design))
        found: list[revision_pb2.RevisionInfo] = []
        while True:
            page = self._ask("ListRevisions", request, design)
            found += page.revisions
            if not page.next_page_token:
                return found
            request.page_token = page.next_page_token

    def info(self) -> server_pb2.ServerInfo:
        """Version, capabilities, limits and load of the daemon."""
        reply: server_pb2.GetServerInfoResponse = self._ask(
            "GetServerInfo", server_pb2.GetServerInfoRequest())
        return reply.server

    def close(self) -> None:
        """Cancels what is under way; ends the daemon too where `local` started it."""
        self._farm.close()
        if self._local is not None:
            self._local.stop()

    def __enter__(self) -> Daemon:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<Daemon {self.address}>"

    def _make(self, exchange: Exchange, timeout: float | None) -> Part:
        exchange = self._carry(exchange, timeout)
        if exchange.error is not None:
            raise exchange.error
        result = exchange.result
        if result is None:
            raise made_here(Error.CODE_CANCELLED, "the request was cancelled", Error.CANCELLED)
        return Part(self, result.revision, result.report, exchange, result.durable,
                    result.head_conflict, exchange.route)

    def _carry(self, exchange: Exchange, timeout: float | None) -> Exchange:
        """Has it answered, by the next replica where one is not available; returns the exchange
        that was."""
        search = Search(self._farm, exchange.route)
        while True:
            replica = search.replica()
            left = None if timeout is None else timeout - search.seconds()
            replica.stream.send(exchange)
            replica.stream.wait(exchange, lambda sent: sent.has_result, left)
            replica.reached |= exchange.heard
            if exchange.error is None:
                return exchange
            wait = search.delay(replica, exchange.error, exchange.broken)
            if wait is None or exchange.overdue or (
                    timeout is not None and search.seconds() + wait > timeout):
                return exchange
            time.sleep(wait)
            exchange = exchange.again()

    def _ask(self, method: str, request: Any, route: str = "") -> Any:
        """A call that changes nothing."""
        def call(replica: Replica) -> Any:
            return replica.call(method, request, route)
        return self._again(call, route)

    def _read(self, method: str, request: Any, route: str,
              assemble: Callable[[Iterator[Any]], T]) -> T:
        """What is made of the messages that a call answers with."""
        return self._again(lambda replica: assemble(
            messages(lambda: replica.call(method, request, route))), route)

    def _fetch(self, revision: str, route: str = "") -> Content:
        """A whole mesh by GetMesh."""
        def assemble(answers: Iterator[Any]) -> Content:
            assembler = MeshAssembler()
            for message in answers:
                assembler.add(message.mesh)
            return assembler.content
        return self._read("GetMesh", mesh_pb2.GetMeshRequest(revision=revision), route, assemble)

    def _write_file(self, revision: str, path: os.PathLike[str] | str, route: str) -> Path:
        request = mesh_pb2.GetMeshFileRequest(revision=revision,
                                              format=_requests.format_of(path))

        def assemble(answers: Iterator[Any]) -> bytes:
            assembler = FileAssembler()
            for message in answers:
                assembler.add(message)
            return assembler.finish()
        return write_whole(path, self._read("GetMeshFile", request, route, assemble))

    def _velocities(self, revision: str, parameters: Iterable[str],
                    route: str) -> dict[str, Velocity]:
        request = motion_pb2.GetDesignVelocitiesRequest(revision=revision, parameters=parameters)

        def assemble(answers: Iterator[Any]) -> dict[str, Velocity]:
            assembler = VelocityAssembler()
            for message in answers:
                assembler.add(message)
            return assembler.finish()
        return self._read("GetDesignVelocities", request, route, assemble)

    def _gradient(self, revision: str, seed: npt.ArrayLike, parameters: Iterable[str],
                  route: str) -> dict[str, Derivative]:
        return gradient(self._ask("GetDesignGradient", motion_pb2.GetDesignGradientRequest(
            revision=revision, parameters=parameters, seed=seed_bytes(seed)), route))

    def _horizon(self, revision: str, parameters: Iterable[str], hold: float | None,
                 route: str) -> dict[str, Horizon]:
        return horizons(self._ask(
            "GetConnectivityHorizon", motion_pb2.GetConnectivityHorizonRequest(
                revision=revision, parameters=parameters, hold=hold), route))

    def _document(self, revision: str, route: str) -> dict[str, Any]:
        reply = self._ask("GetRevision", revision_pb2.GetRevisionRequest(
            revision=revision, documents=True), route)
        document: dict[str, Any] = json.loads(reply.model_document)
        return document

    def _again(self, call: Callable[[Replica], T], route: str) -> T:
        """Makes a call that changes nothing again where the connection breaks."""
        search = Search(self._farm, route)
        while True:
            replica = search.replica()
            try:
                answer = call(replica)
            except grpc.RpcError as failure:
                error = from_rpc(failure)
                replica.reached |= was_answered(failure)
                wait = search.delay(replica, error, is_broken(failure))
                if wait is None:
                    raise error from None
                time.sleep(wait)
            else:
                replica.reached = True
                return answer


def connect(address: str | Sequence[str] | None = None, *, patience: float = PATIENCE,
            tls_ca: os.PathLike[str] | str | None = None,
            tls_cert: os.PathLike[str] | str | None = None,
            tls_key: os.PathLike[str] | str | None = None,
            token_file: os.PathLike[str] | str | None = None) -> Daemon:
    """A connection to a daemon; nothing is sent before the first request.

    address: `HOST:PORT`, `unix:/PATH`, or `local` for a daemon that is started for it, as by
    `local()`; or several, as a list or with commas between, of daemons that share a tier: each loop
    goes to one of them, and to the next where that is not available. Default: REMESH_ADDRESS, else
    127.0.0.1:50051. patience: s for which a request is sent again where none is available. The
    others are PEM files of TLS, and a file with a token. Raises OSError where a file cannot be
    read, InvalidRequest for a token that would go in the clear to another machine, ValueError for
    no address, and for `local` among others.
    """
    addresses = addresses_or_default(address)
    if addresses == ["local"]:
        return local()
    return Daemon(addresses, Access(tls_ca, tls_cert, tls_key, token_file), patience=patience)


def local(program: os.PathLike[str] | str | None = None, *options: str) -> Daemon:
    """Starts a daemon of its own, on a Unix socket in a temporary folder that has its store too.

    It ends, and the folder goes, with `close()` or the `with` statement, and when this process
    ends, however that comes about. program: `remeshd`; default: the one that was installed with
    this package, else the one on PATH. options: further ones of its command line, `--workers`,
    `4`. Raises Unavailable where there is none or it does not start, with what it said.
    """
    started = LocalDaemon(program, options)
    try:
        return Daemon([started.address], local=started)
    except BaseException:
        started.stop()
        raise
