# SPDX-License-Identifier: Apache-2.0
"""The same client for asyncio.

    from remesh_client import aio
    async with aio.connect() as daemon:
        part = await daemon.mesh("bracket.json", nodes=8000)
        part = await part.edit(radius=8)
        mesh = await part.mesh()
        await part.write("b.inp")

Arguments, results and errors are those of the synchronous client. Cancelling a task cancels its
computation and no other.
"""
from __future__ import annotations

import asyncio
import os
import time
from pathlib import Path
from types import TracebackType
from typing import Any, Awaitable, Callable, Mapping, TypeVar

import grpc.aio
import numpy.typing as npt

from remesh_client import _requests
from remesh_client._aio_stream import EditStream
from remesh_client._assembler import Content, MeshAssembler
from remesh_client._connection import Access, address_or_default, channel_options
from remesh_client._exchange import BETWEEN_TRIES, RECONNECT, Exchange, OnProgress, is_broken
from remesh_client._files import FileAssembler, write_whole
from remesh_client._motion import (Derivative, Horizon, Velocity, VelocityAssembler, gradient,
                                   horizons, seed_bytes)
from remesh_client.edits import EditLike, Model
from remesh_client.errors import Error, from_rpc, made_here
from remesh_client.local import LocalDaemon
from remesh_client.mesh import Mesh
from remesh_client.part import Revision
from remesh_client.v1 import (mesh_pb2, motion_pb2, remesh_pb2_grpc, report_pb2, revision_pb2,
                              server_pb2)

T = TypeVar("T")


class Part(Revision):
    """As the synchronous Part; what asks the daemon is awaited."""

    def __init__(self, daemon: Daemon, info: revision_pb2.RevisionInfo, report: report_pb2.Report,
                 exchange: Exchange | None = None, durable: bool = False,
                 head_conflict: bool = False) -> None:
        super().__init__(info, report, exchange, durable, head_conflict)
        self._daemon = daemon

    async def edit(self, *edits: EditLike, options: Mapping[str, Any] | None = None,
                   mesh: bool = True, file: bool | None = None, progress: OnProgress | None = None,
                   timeout: float | None = None, **parameters: Any) -> Part:
        """The model after edits, remeshed, as Part.edit of the synchronous client."""
        return await self._daemon._make(_requests.edit_of(
            self.revision, edits, parameters, options or {}, file, mesh, self._base(), progress),
            timeout)

    async def mesh(self) -> Mesh:
        """Its mesh; the same object each time. Raises RemeshError."""
        if self._mesh is None:
            if self._exchange is not None:
                await self._daemon._stream.wait(self._exchange, lambda sent: sent.done)
            content = self._content() or await self._daemon._fetch(self.revision)
            self._mesh = Mesh(content)
            self._exchange = None
        return self._mesh

    async def velocities(self, *parameters: str) -> dict[str, Velocity]:
        """d(node)/d(parameter), as Part.velocities."""
        request = motion_pb2.GetDesignVelocitiesRequest(revision=self.revision,
                                                        parameters=parameters)

        async def transfer() -> dict[str, Velocity]:
            assembler = VelocityAssembler()
            async for message in self._daemon._stub.GetDesignVelocities(
                    request, metadata=self._daemon._metadata):
                assembler.add(message)
            return assembler.finish()
        return await self._daemon._again(transfer)

    async def gradient(self, seed: npt.ArrayLike, *parameters: str) -> dict[str, Derivative]:
        """d(function)/d(parameter), as Part.gradient."""
        request = motion_pb2.GetDesignGradientRequest(
            revision=self.revision, parameters=parameters, seed=seed_bytes(seed))

        async def ask() -> motion_pb2.GetDesignGradientResponse:
            reply: motion_pb2.GetDesignGradientResponse = (
                await self._daemon._stub.GetDesignGradient(request,
                                                           metadata=self._daemon._metadata))
            return reply
        return gradient(await self._daemon._again(ask))

    async def horizon(self, *parameters: str, hold: float | None = None) -> dict[str, Horizon]:
        """How far parameters may go, as Part.horizon."""
        request = motion_pb2.GetConnectivityHorizonRequest(
            revision=self.revision, parameters=parameters, hold=hold)

        async def ask() -> motion_pb2.GetConnectivityHorizonResponse:
            reply: motion_pb2.GetConnectivityHorizonResponse = (
                await self._daemon._stub.GetConnectivityHorizon(
                    request, metadata=self._daemon._metadata))
            return reply
        return horizons(await self._daemon._again(ask))

    async def write(self, path: os.PathLike[str] | str) -> Path:
        """Writes the mesh by the daemon's own writers, as Mesh.write."""
        return await self._daemon._write_file(self.revision, path)


class Daemon:
    """Made by `connect` or `local`; an asynchronous context manager, for one event loop."""

    def __init__(self, address: str, access: Access = Access(),
                 local: LocalDaemon | None = None) -> None:
        self.address = address
        self._local = local
        self._metadata = access.metadata(address)
        options = channel_options(address)
        self._channel = (grpc.aio.secure_channel(address, access.credentials(), options)
                         if access.encrypts else grpc.aio.insecure_channel(address, options))
        self._stub: Any = remesh_pb2_grpc.RemeshServiceStub(self._channel)  # type: ignore
        self._reached = False
        self._stream = EditStream(lambda: self._stub.EditStream(metadata=self._metadata))

    async def mesh(self, model: Model, *, design: str = "", file: bool | None = None,
                   with_mesh: bool = True, progress: OnProgress | None = None,
                   timeout: float | None = None, **options: Any) -> Part:
        """Meshes a model, as Daemon.mesh of the synchronous client."""
        return await self._make(_requests.first_mesh(model, options, design, file, with_mesh,
                                                     progress), timeout)

    async def open(self, revision: str) -> Part:
        """A revision that is there. Raises NotFound."""
        request = revision_pb2.GetRevisionRequest(revision=revision)

        async def ask() -> revision_pb2.GetRevisionResponse:
            reply: revision_pb2.GetRevisionResponse = await self._stub.GetRevision(
                request, metadata=self._metadata)
            return reply
        reply = await self._again(ask)
        return Part(self, reply.revision, reply.report, durable=reply.durable)

    async def info(self) -> server_pb2.ServerInfo:
        """Version, capabilities, limits and load of the daemon."""
        async def ask() -> server_pb2.GetServerInfoResponse:
            reply: server_pb2.GetServerInfoResponse = await self._stub.GetServerInfo(
                server_pb2.GetServerInfoRequest(), metadata=self._metadata)
            return reply
        return (await self._again(ask)).server

    async def close(self) -> None:
        """Cancels what is under way; ends the daemon too where `local` started it."""
        await self._stream.cancel_all()
        await self._channel.close()
        if self._local is not None:
            await asyncio.to_thread(self._local.stop)

    async def __aenter__(self) -> Daemon:
        return self

    async def __aexit__(self, kind: type[BaseException] | None, error: BaseException | None,
                        trace: TracebackType | None) -> None:
        await self.close()

    async def _make(self, exchange: Exchange, timeout: float | None) -> Part:
        await self._stream.send(exchange)
        await self._stream.wait(exchange, lambda sent: sent.has_result, timeout)
        if exchange.error is not None:
            raise exchange.error
        result = exchange.result
        if result is None:
            raise made_here(Error.CODE_CANCELLED, "the request was cancelled", Error.CANCELLED)
        return Part(self, result.revision, result.report, exchange, result.durable,
                    result.head_conflict)

    async def _fetch(self, revision: str) -> Content:
        async def transfer() -> Content:
            assembler = MeshAssembler()
            async for message in self._stub.GetMesh(mesh_pb2.GetMeshRequest(revision=revision),
                                                    metadata=self._metadata):
                assembler.add(message.mesh)
            return assembler.content
        return await self._again(transfer)

    async def _write_file(self, revision: str, path: os.PathLike[str] | str) -> Path:
        request = mesh_pb2.GetMeshFileRequest(revision=revision,
                                              format=_requests.format_of(path))

        async def transfer() -> bytes:
            assembler = FileAssembler()
            async for message in self._stub.GetMeshFile(request, metadata=self._metadata):
                assembler.add(message)
            return assembler.finish()
        return await asyncio.to_thread(write_whole, path, await self._again(transfer))

    async def _again(self, call: Callable[[], Awaitable[T]]) -> T:
        """Makes a call that changes nothing again where the connection breaks."""
        begun = time.monotonic()
        while True:
            try:
                answer = await call()
            except grpc.RpcError as failure:
                late = time.monotonic() - begun > RECONNECT
                if late or not self._reached or not is_broken(failure):
                    raise from_rpc(failure) from None
                await asyncio.sleep(BETWEEN_TRIES)
            else:
                self._reached = True
                return answer


def connect(address: str | None = None, *, tls_ca: os.PathLike[str] | str | None = None,
            tls_cert: os.PathLike[str] | str | None = None,
            tls_key: os.PathLike[str] | str | None = None,
            token_file: os.PathLike[str] | str | None = None) -> Daemon:
    """A connection to a daemon, as `remesh_client.connect`; to be made where a loop runs."""
    address = address_or_default(address)
    if address == "local":
        return local()
    return Daemon(address, Access(tls_ca, tls_cert, tls_key, token_file))


def local(program: os.PathLike[str] | str | None = None, *options: str) -> Daemon:
    """Starts a daemon of its own, as `remesh_client.local`."""
    started = LocalDaemon(program, options)
    try:
        return Daemon(started.address, local=started)
    except BaseException:
        started.stop()
        raise
