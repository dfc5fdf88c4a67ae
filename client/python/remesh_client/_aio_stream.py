# SPDX-License-Identifier: Apache-2.0
"""The EditStream beneath an asynchronous Daemon: one task reads the answers for all."""
from __future__ import annotations

import asyncio
from typing import Any, Callable

import grpc
import grpc.aio

from remesh_client._exchange import (Exchange, cancel_request, is_broken, stream_ended,
                                     was_answered)
from remesh_client.errors import Error, made_here


class EditStream:
    """For one event loop. When the stream breaks, its unanswered requests fail with `broken` set;
    the caller sends them again."""

    def __init__(self, open_call: Callable[[str], Any]) -> None:
        """open_call: begins a call of EditStream, of the route of its first request."""
        self._open_call = open_call
        self._call: Any = None
        self._outgoing: asyncio.Queue[Any] = asyncio.Queue()  # of the call
        self._writer: asyncio.Task[None] | None = None
        self._reader: asyncio.Task[None] | None = None
        self._unanswered: dict[str, Exchange] = {}  # in the order sent
        self._changed = asyncio.Condition()  # an answer has come
        self._raised: dict[str, BaseException] = {}  # by progress callbacks

    async def send(self, exchange: Exchange) -> None:
        if self._call is None or not self._unanswered and self._call.done():
            self._begin(exchange.route)
        self._unanswered[exchange.id] = exchange
        exchange.carrier = self
        if self._reader is None or self._reader.done():
            self._reader = asyncio.create_task(self._read())
        self._outgoing.put_nowait(exchange.request)

    async def wait(self, exchange: Exchange, done: Callable[[Exchange], bool],
                   timeout: float | None = None) -> None:
        """Waits until `done(exchange)`, or until the whole request is answered. timeout: s; after
        that the request is cancelled. Where the waiting task is cancelled, so is the request, at
        the daemon too. Raises what the progress callback raised."""
        def ready() -> bool:
            return exchange.done or done(exchange) or exchange.id in self._raised
        try:
            async with self._changed:
                try:
                    await asyncio.wait_for(self._changed.wait_for(ready), timeout)
                except asyncio.TimeoutError:
                    exchange.overdue = True
                    self._cancel(exchange)
                    await self._changed.wait_for(ready)
        except asyncio.CancelledError:
            self._cancel(exchange)
            raise
        if exchange.id in self._raised:
            self._cancel(exchange)
            raise self._raised.pop(exchange.id)

    async def cancel_all(self) -> None:
        call, self._call = self._call, None
        reader, self._reader = self._reader, None
        if reader is not None:
            reader.cancel()
            await asyncio.gather(reader, return_exceptions=True)
        self._end_writing()
        if call is not None:
            call.cancel()
        unanswered = list(self._unanswered.values())
        self._unanswered.clear()
        await self._fail(unanswered, lambda: made_here(
            Error.CODE_CANCELLED, "the request was cancelled", Error.CANCELLED))

    def _begin(self, route: str) -> None:
        self._end_writing()
        self._call = self._open_call(route)
        self._outgoing = asyncio.Queue()
        self._writer = asyncio.create_task(self._write(self._call, self._outgoing))

    def _end_writing(self) -> None:
        if self._writer is not None:
            self._writer.cancel()
            self._writer = None

    def _cancel(self, exchange: Exchange) -> None:
        if exchange.id in self._unanswered and self._call is not None:
            self._outgoing.put_nowait(cancel_request(exchange))

    @staticmethod
    async def _write(call: Any, outgoing: asyncio.Queue[Any]) -> None:
        """A task of its own: where a task is cancelled while it writes, gRPC cancels the call."""
        try:
            while True:
                await call.write(await outgoing.get())
        except (grpc.RpcError, asyncio.InvalidStateError):
            pass  # the call is at its end: the reader sees to it

    async def _read(self) -> None:
        """While something is unanswered. Ends of streams and faults go to the requests."""
        while self._unanswered:
            try:
                answer = await self._call.read()
                if answer is grpc.aio.EOF:
                    await self._ended(None if await self._call.code() is grpc.StatusCode.OK
                                      else await self._failure())
                    continue
            except grpc.RpcError as failure:
                await self._ended(failure)
                continue
            await self._take(answer)

    async def _failure(self) -> grpc.aio.AioRpcError:
        call = self._call
        return grpc.aio.AioRpcError(await call.code(), await call.initial_metadata(),
                                    await call.trailing_metadata(), await call.details())

    async def _take(self, answer: Any) -> None:
        exchange = self._unanswered.get(answer.request_id)
        if exchange is None:
            return
        try:
            exchange.take(answer)
        except Exception as raised:  # by the progress callback: whoever waits hears of it
            self._raised[exchange.id] = raised
        if exchange.done:
            self._unanswered.pop(exchange.id, None)
        async with self._changed:
            self._changed.notify_all()

    async def _ended(self, failure: grpc.RpcError | None) -> None:
        """Tells all that is unanswered; the next request begins another call."""
        self._call = None
        self._end_writing()  # what has not been written belongs to the call that ended
        for exchange in self._unanswered.values():
            exchange.broken = failure is None or is_broken(failure)
            exchange.heard |= failure is None or was_answered(failure)
        unanswered = list(self._unanswered.values())
        self._unanswered.clear()
        await self._fail(unanswered, lambda: stream_ended(failure))

    async def _fail(self, exchanges: list[Exchange], why: Callable[[], Any]) -> None:
        for exchange in exchanges:
            exchange.fail(why())
        async with self._changed:
            self._changed.notify_all()
