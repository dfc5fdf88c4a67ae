# SPDX-License-Identifier: Apache-2.0
"""Answers of a streaming call, read on a thread of their own.

A KeyboardInterrupt that strikes within gRPC may leave one of its locks taken, and the channel
dead. It strikes the main thread alone, which therefore waits in a SimpleQueue.
"""
from __future__ import annotations

import queue
import threading
from typing import Any, Callable, Iterator

READ_AHEAD = 16  # messages


class Answers:
    """An iterator over the messages of one call. Raises what the call does."""

    def __init__(self, open_call: Callable[[], Any]) -> None:
        """open_call: begins the call."""
        self._open_call = open_call
        self._call: Any = None
        self._read: queue.SimpleQueue[tuple[Any, BaseException | None]] = queue.SimpleQueue()
        self._credits: queue.SimpleQueue[None] = queue.SimpleQueue()  # one for each to be read
        self.ended = False  # no more is read
        self._cancelled = False
        for _ in range(READ_AHEAD):
            self._credits.put(None)
        threading.Thread(target=self._run, name="remesh answers", daemon=True).start()

    def __iter__(self) -> Answers:
        return self

    def __next__(self) -> Any:
        message, failure = self._read.get()
        if failure is not None:
            self._read.put((None, failure))  # for the next one that asks
            raise failure
        self._credits.put(None)
        return message

    def cancel(self) -> None:
        """Ends the call; what was read and not taken may still come."""
        self._cancelled = True
        self._credits.put(None)
        if self._call is not None:
            self._call.cancel()

    def _run(self) -> None:
        try:
            self._call = self._open_call()
            if self._cancelled:
                self._call.cancel()
            while True:
                self._credits.get()
                self._read.put((next(self._call), None))
        except BaseException as failure:  # StopIteration at the end
            self.ended = True
            self._read.put((None, failure))


def messages(open_call: Callable[[], Any]) -> Iterator[Any]:
    """Those of one call, which is cancelled where they are not all taken."""
    answers = Answers(open_call)
    try:
        yield from answers
    finally:
        answers.cancel()
