# SPDX-License-Identifier: Apache-2.0
"""One request of an EditStream and its answers, whoever reads them."""
from __future__ import annotations

import itertools
from typing import Any, Callable

from remesh_client._assembler import Content, MeshAssembler
from remesh_client.errors import (DeadlineExceeded, Error, RemeshError, error_of_rpc, from_error,
                                  made_here)
from remesh_client.v1 import revision_pb2, stream_pb2

import grpc

Progress = stream_pb2.Progress
OnProgress = Callable[[Progress], object]
_ids = itertools.count(1)


class Exchange:
    """A request sent, its result and its mesh or what went wrong with either."""

    def __init__(self, request: stream_pb2.EditStreamRequest, document: str = "",
                 base: Callable[[], Content | None] = lambda: None,
                 on_progress: OnProgress | None = None, route: str = "") -> None:
        """base: the mesh that a delta is against, asked for when the mesh begins to come.
        route: which of several daemons it goes to, as Farm takes it."""
        self.id = f"python-{next(_ids)}"
        if request.HasField("edit"):
            request.edit.request_id = self.id
        else:
            request.create.request_id = self.id
        self.request = request
        self.result: revision_pb2.RevisionResult | None = None
        self.mesh: Content | None = None
        self.error: RemeshError | None = None  # of the request
        self.mesh_error: RemeshError | None = None  # after the result
        self.heard = False  # something was answered
        self.done = False
        self.overdue = False  # cancelled because its time was up
        self.broken = False  # what carried it broke
        self.route = route
        self.carrier: Any = None  # the EditStream that it was sent on
        self._document = document
        self._base = base
        self._on_progress = on_progress
        self._wants_mesh = request.HasField("mesh")
        self._assembler: MeshAssembler | None = None

    @property
    def has_result(self) -> bool:
        """The result is there, or will not come."""
        return self.result is not None or self.done

    def take(self, answer: stream_pb2.EditStreamResponse) -> None:
        """Takes one answer; what the progress callback raises goes through."""
        self.heard = True
        what = answer.WhichOneof("answer")
        if what == "progress":
            if self._on_progress is not None:
                self._on_progress(answer.progress)
        elif what == "result":
            self.result = answer.result
            if not self._wants_mesh:
                self._finish()
        elif what == "mesh":
            self._take_mesh(answer)
        elif what == "error":
            self.fail(from_error(answer.error, self._document))

    def fail(self, error: RemeshError) -> None:
        if self.overdue and error.code == "CANCELLED":
            error = DeadlineExceeded(Error(
                code=Error.CODE_DEADLINE_EXCEEDED, reason=Error.DEADLINE_PASSED,
                message="the time given to the request has passed",
                hint="give more time, or ask for fewer nodes"))
        if self.result is None:
            self.error = error
        else:
            self.mesh_error = error
        self._finish()

    def again(self) -> Exchange:
        """The same request, to be sent once more. Pre: it failed."""
        return Exchange(self.request, self._document, self._base, self._on_progress, self.route)

    def _take_mesh(self, answer: stream_pb2.EditStreamResponse) -> None:
        if self.mesh_error is None:
            try:
                if self._assembler is None:
                    self._assembler = MeshAssembler(self.request.mesh.arrays, self._base())
                self._assembler.add(answer.mesh)
                if self._assembler.ended:
                    self.mesh = self._assembler.content
            except RemeshError as damage:  # the rest of the mesh is passed over
                self.mesh_error = damage
        if answer.mesh.HasField("end"):
            self._finish()

    def _finish(self) -> None:
        self.done = True
        self._assembler = None
        if self.error is None:  # else it may be sent again
            self._base = lambda: None
            self._on_progress = None


# What gRPC says of calls that a balancer in between reset, cut, or answered itself.
_CUT = ("RST_STREAM", "Stream removed", "http2 header with status: 5")


def is_broken(failure: grpc.RpcError) -> bool:
    """The connection broke, or the daemon ended: it cancels its calls then. What a balancer does to
    a call whose daemon died gRPC takes for an internal error or one that it does not know; the
    daemon's own say nothing of that kind."""
    if failure.code() in (grpc.StatusCode.INTERNAL, grpc.StatusCode.UNKNOWN):
        return any(cut in (failure.details() or "") for cut in _CUT)
    return failure.code() in (grpc.StatusCode.UNAVAILABLE, grpc.StatusCode.CANCELLED)


def was_answered(failure: grpc.RpcError) -> bool:
    """By the daemon, or by a balancer that says that there is none: somebody is there."""
    return bool(failure.trailing_metadata() or failure.initial_metadata())


def stream_ended(failure: grpc.RpcError | None) -> RemeshError:
    """What requests hear that a stream left unanswered."""
    if failure is not None:
        return from_error(error_of_rpc(failure))
    return made_here(Error.CODE_UNAVAILABLE,
                     "the stream ended before this request was answered", Error.STREAM_ENDED)


def cancel_request(exchange: Exchange) -> stream_pb2.EditStreamRequest:
    """The message that cancels it."""
    return stream_pb2.EditStreamRequest(
        cancel=stream_pb2.CancelRequest(request_id=exchange.id))
