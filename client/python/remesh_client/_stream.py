# SPDX-License-Identifier: Apache-2.0
"""The EditStream beneath a Daemon: requests sent, answers read by whoever waits for one."""
from __future__ import annotations

import queue
import threading
import time
from typing import Any, Callable, Iterator

import grpc

from remesh_client._answers import Answers
from remesh_client._exchange import (Exchange, cancel_request, is_broken, stream_ended,
                                     was_answered)
from remesh_client.errors import Error, made_here
from remesh_client.v1 import stream_pb2

Request = stream_pb2.EditStreamRequest
OpenCall = Callable[[str, Iterator[Request]], Any]


class _Call:
    """One call of EditStream; after one that broke the next request begins another."""

    def __init__(self, open_call: OpenCall, route: str) -> None:
        self._requests: queue.SimpleQueue[Request | None] = queue.SimpleQueue()
        self.answers = Answers(lambda: open_call(route, iter(self._requests.get, None)))

    def send(self, request: Request) -> None:
        self._requests.put(request)

    def end(self) -> None:
        self._requests.put(None)

    def cancel(self) -> None:
        self.answers.cancel()
        self.end()

    def is_active(self) -> bool:
        return not self.answers.ended


class EditStream:
    """May be used by several threads. One of the waiting threads reads for all. When the stream
    breaks, its unanswered requests fail with `broken` set; the caller sends them again."""

    def __init__(self, open_call: OpenCall) -> None:
        """open_call: begins a call of EditStream, of the route of the first request, with the
        requests that it is given."""
        self._open_call = open_call
        self._call: _Call | None = None
        self._unanswered: dict[str, Exchange] = {}  # in the order sent
        self._state = threading.Lock()  # guards these
        self._reading = threading.RLock()  # one reads

    def send(self, exchange: Exchange) -> None:
        with self._state:
            if self._call is None or not (self._unanswered or self._call.is_active()):
                self._call = _Call(self._open_call, exchange.route)
            self._unanswered[exchange.id] = exchange
            exchange.carrier = self
            self._call.send(exchange.request)

    def wait(self, exchange: Exchange, done: Callable[[Exchange], bool],
             timeout: float | None = None) -> None:
        """Reads answers until `done(exchange)`, or until the whole request is answered. timeout: s;
        after that the request is cancelled. After an exception (KeyboardInterrupt, or one of the
        progress callback) all requests of this stream are cancelled, at the daemon too."""
        timer = None
        if timeout is not None and not done(exchange):
            timer = threading.Timer(timeout, self._give_up, [exchange])
            timer.daemon = True
            timer.start()
        try:
            with self._reading:
                while not (exchange.done or done(exchange)):
                    self._read()
        except BaseException:
            self.cancel_all()
            raise
        finally:
            if timer is not None:
                timer.cancel()

    def cancel_all(self) -> None:
        """Cancels all requests; the next one begins another call."""
        with self._state:
            call, self._call = self._call, None
            unanswered = list(self._unanswered.values())
            self._unanswered.clear()
        if call is not None:
            call.cancel()
        for exchange in unanswered:
            exchange.fail(made_here(Error.CODE_CANCELLED, "the request was cancelled",
                                    Error.CANCELLED))

    def _give_up(self, exchange: Exchange) -> None:
        exchange.overdue = True
        with self._state:
            if self._call is not None and exchange.id in self._unanswered:
                self._call.send(cancel_request(exchange))

    def _read(self) -> None:
        """Takes one answer. Pre: something is unanswered, and nobody else reads."""
        with self._state:
            call = self._call
        if call is None:  # cancelled by another thread, which tells whom it concerns
            time.sleep(0.001)
            return
        try:
            answer = next(call.answers)
        except grpc.RpcError as failure:
            self._end(call, failure)
        except StopIteration:
            self._end(call, None)
        else:
            self._take(answer)

    def _take(self, answer: stream_pb2.EditStreamResponse) -> None:
        exchange = self._unanswered.get(answer.request_id)
        if exchange is None:
            return
        exchange.take(answer)
        if exchange.done:
            with self._state:
                self._unanswered.pop(exchange.id, None)

    def _end(self, call: _Call, failure: grpc.RpcError | None) -> None:
        with self._state:
            if call is not self._call:  # cancelled by another thread
                return
            self._call = None
            unanswered = list(self._unanswered.values())
            self._unanswered.clear()
        for exchange in unanswered:
            exchange.broken = failure is None or is_broken(failure)
            exchange.heard |= failure is None or was_answered(failure)
            exchange.fail(stream_ended(failure))
