# SPDX-License-Identifier: Apache-2.0
"""The same client for asyncio.

    from remesh_client import aio
    async with aio.connect() as daemon:
        part = await daemon.mesh("bracket.json", nodes=8000)
        part = await part.edit(hole_radius=8)
        mesh = await part.mesh()
        await part.write("b.inp")

Arguments, results and errors are those of the synchronous client. Cancelling a task cancels its
computation and no other.
"""
from __future__ import annotations

import asyncio
import os
from pathlib import Path
from types import TracebackType
from typing import Any, AsyncIterator, Awaitable, Callable, Mapping, Sequence, TypeVar

import grpc
import numpy.typing as npt

from remesh_client import _requests
from remesh_client._aio_farm import Farm, Replica
from remesh_client._assembler import Content, MeshAssembler
from remesh_client._connection import Access, addresses_or_default
from remesh_client._exchange import Exchange, OnProgress, is_broken, was_answered
from remesh_client._files import FileAssembler, write_whole
from remesh_client._motion import (Derivative, Horizon, Velocity, VelocityAssembler, gradient,
                                   horizons, seed_bytes)
from remesh_client._search import PATIENCE, Search, route_of
from remesh_client.edits import EditLike, Model
from remesh_client.errors import Error, from_rpc, made_here
from remesh_client.local import LocalDaemon
from remesh_client.mesh import Mesh
from remesh_client.part import Revision, in_several
from remesh_client.v1 import mesh_pb2, motion_pb2, report_pb2, revision_pb2, server_pb2

T = TypeVar("T")


class Part(Revision):
    """As the synchronous Part; what asks the daemon is awaited."""

    def __init__(self, daemon: Daemon, info: revision_pb2.RevisionInfo, report: report_pb2.Report,
                 exchange: Exchange | None = None, durable: bool = False,
                 head_conflict: bool = False, route: str | None = None,
                 in_several: bool = False) -> None:
        super().__init__(info, report, exchange, durable, head_conflict, in_several)
        self._daemon = daemon
        self._route: str = route or info.design or info.root

    async def edit(self, *edits: EditLike, options: Mapping[str, Any] | None = None,
                   mesh: bool = True, file: bool | None = None, progress: OnProgress | None = None,
                   timeout: float | None = None, **parameters: Any) -> Part:
        """The model after edits, remeshed, as Part.edit of the synchronous client."""
        return await self._daemon._make(_requests.edit_of(
            self.revision, edits, parameters, options or {}, self._filed(file), mesh, self._base(),
            progress, self._route, self._design_of(file)), timeout)

    async def mesh(self) -> Mesh:
        """Its mesh; the same object each time. Raises RemeshError."""
        if self._mesh is None:
            if self._exchange is not None and self._exchange.carrier is not None:
                await self._exchange.carrier.wait(self._exchange, lambda sent: sent.done)
            return self._keep(self._content() or
                              await self._daemon._fetch(self.revision, self._route))
        return self._mesh

    async def velocities(self, *parameters: str) -> dict[str, Velocity]:
        """d(node)/d(parameter), as Part.velocities."""
        async def assemble(answers: AsyncIterator[Any]) -> dict[str, Velocity]:
            assembler = VelocityAssembler()
            async for message in answers:
                assembler.add(message)
            return assembler.finish()
        return await self._daemon._read("GetDesignVelocities", motion_pb2.GetDesignVelocitiesRequest(
            revision=self.revision, parameters=parameters), self._route, assemble)

    async def gradient(self, seed: npt.ArrayLike, *parameters: str) -> dict[str, Derivative]:
        """d(function)/d(parameter), as Part.gradient."""
        return gradient(await self._daemon._ask(
            "GetDesignGradient", motion_pb2.GetDesignGradientRequest(
                revision=self.revision, parameters=parameters, seed=seed_bytes(seed)), self._route))

    async def horizon(self, *parameters: str, hold: float | None = None) -> dict[str, Horizon]:
        """How far parameters may go, as Part.horizon."""
        return horizons(await self._daemon._ask(
            "GetConnectivityHorizon", motion_pb2.GetConnectivityHorizonRequest(
                revision=self.revision, parameters=parameters, hold=hold), self._route))

    async def write(self, path: os.PathLike[str] | str) -> Path:
        """Writes the mesh by the daemon's own writers, as Mesh.write."""
        return await self._daemon._write_file(self.revision, path, self._route)


class Daemon:
    """Made by `connect` or `local`; an asynchronous context manager, for one event loop."""

    def __init__(self, addresses: Sequence[str], access: Access = Access(),
                 local: LocalDaemon | None = None, patience: float = PATIENCE) -> None:
        self.address = ",".join(addresses)
        self._local = local
        self._farm = Farm(addresses, access, patience)

    async def mesh(self, model: Model, *, design: str = "", file: bool | None = None,
                   with_mesh: bool = True, progress: OnProgress | None = None,
                   timeout: float | None = None, route: str | None = None, **options: Any) -> Part:
        """Meshes a model, as Daemon.mesh of the synchronous client."""
        return await self._make(_requests.first_mesh(model, options, design, file, with_mesh,
                                                     progress, route), timeout)

    async def open(self, revision: str) -> Part:
        """A revision that is there. Raises NotFound."""
        reply = await self._ask("GetRevision", revision_pb2.GetRevisionRequest(revision=revision),
                                route_of(revision))
        return Part(self, reply.revision, reply.report, durable=reply.durable,
                    in_several=in_several(revision, reply))

    async def info(self) -> server_pb2.ServerInfo:
        """Version, capabilities, limits and load of the daemon."""
        reply: server_pb2.GetServerInfoResponse = await self._ask(
            "GetServerInfo", server_pb2.GetServerInfoRequest())
        return reply.server

    async def close(self) -> None:
        """Cancels what is under way; ends the daemon too where `local` started it."""
        await self._farm.close()
        if self._local is not None:
            await asyncio.to_thread(self._local.stop)

    async def __aenter__(self) -> Daemon:
        return self

    async def __aexit__(self, kind: type[BaseException] | None, error: BaseException | None,
                        trace: TracebackType | None) -> None:
        await self.close()

    async def _make(self, exchange: Exchange, timeout: float | None) -> Part:
        exchange = await self._carry(exchange, timeout)
        if exchange.error is not None:
            raise exchange.error
        result = exchange.result
        if result is None:
            raise made_here(Error.CODE_CANCELLED, "the request was cancelled", Error.CANCELLED)
        return Part(self, result.revision, result.report, exchange, result.durable,
                    result.head_conflict, exchange.route)

    async def _carry(self, exchange: Exchange, timeout: float | None) -> Exchange:
        """Has it answered, as the synchronous client does."""
        search = Search(self._farm, exchange.route)
        while True:
            replica = search.replica()
            left = None if timeout is None else max(0.0, timeout - search.seconds())
            await replica.stream.send(exchange)
            await replica.stream.wait(exchange, lambda sent: sent.has_result, left)
            replica.reached |= exchange.heard
            if exchange.error is None:
                return exchange
            wait = search.delay(replica, exchange.error, exchange.broken)
            if wait is None or exchange.overdue or (
                    timeout is not None and search.seconds() + wait > timeout):
                return exchange
            await asyncio.sleep(wait)
            exchange = exchange.again()

    async def _ask(self, method: str, request: Any, route: str = "") -> Any:
        """A call that changes nothing."""
        async def call(replica: Replica) -> Any:
            return await replica.call(method, request, route)
        return await self._again(call, route)

    async def _read(self, method: str, request: Any, route: str,
                    assemble: Callable[[AsyncIterator[Any]], Awaitable[T]]) -> T:
        """What is made of the messages that a call answers with."""
        async def call(replica: Replica) -> T:
            return await assemble(replica.call(method, request, route))
        return await self._again(call, route)

    async def _fetch(self, revision: str, route: str = "") -> Content:
        async def assemble(answers: AsyncIterator[Any]) -> Content:
            assembler = MeshAssembler()
            async for message in answers:
                assembler.add(message.mesh)
            return assembler.content
        return await self._read("GetMesh", mesh_pb2.GetMeshRequest(revision=revision), route,
                                assemble)

    async def _write_file(self, revision: str, path: os.PathLike[str] | str, route: str) -> Path:
        request = mesh_pb2.GetMeshFileRequest(revision=revision,
                                              format=_requests.format_of(path))

        async def assemble(answers: AsyncIterator[Any]) -> bytes:
            assembler = FileAssembler()
            async for message in answers:
                assembler.add(message)
            return assembler.finish()
        return await asyncio.to_thread(
            write_whole, path, await self._read("GetMeshFile", request, route, assemble))

    async def _again(self, call: Callable[[Replica], Awaitable[T]], route: str) -> T:
        """Makes a call that changes nothing again where the connection breaks."""
        search = Search(self._farm, route)
        while True:
            replica = search.replica()
            try:
                answer = await call(replica)
            except grpc.RpcError as failure:
                error = from_rpc(failure)
                replica.reached |= was_answered(failure)
                wait = search.delay(replica, error, is_broken(failure))
                if wait is None:
                    raise error from None
                await asyncio.sleep(wait)
            else:
                replica.reached = True
                return answer


def connect(address: str | Sequence[str] | None = None, *, patience: float = PATIENCE,
            tls_ca: os.PathLike[str] | str | None = None,
            tls_cert: os.PathLike[str] | str | None = None,
            tls_key: os.PathLike[str] | str | None = None,
            token_file: os.PathLike[str] | str | None = None) -> Daemon:
    """A connection to a daemon, or to several that share a tier, as `remesh_client.connect`; to be
    made where a loop runs."""
    addresses = addresses_or_default(address)
    if addresses == ["local"]:
        return local()
    return Daemon(addresses, Access(tls_ca, tls_cert, tls_key, token_file), patience=patience)


def local(program: os.PathLike[str] | str | None = None, *options: str) -> Daemon:
    """Starts a daemon of its own, as `remesh_client.local`."""
    started = LocalDaemon(program, options)
    try:
        return Daemon([started.address], local=started)
    except BaseException:
        started.stop()
        raise
