# SPDX-License-Identifier: Apache-2.0
"""The daemons that a client may ask: one, or the replicas of a farm that share a tier."""
from __future__ import annotations

import hashlib
import time
from typing import Any, Sequence

import grpc

from remesh_client._connection import Access, channel_options
from remesh_client._exchange import BETWEEN_TRIES
from remesh_client._stream import EditStream
from remesh_client.errors import RemeshError
from remesh_client.v1 import remesh_pb2_grpc

AWAY = 1.0  # s for which a replica that did not answer is passed over
_ROUTE = "x-remesh-key"  # by which a balancer in between sends all of a loop to one replica


class Replica:
    """One daemon, its channel and the stream of this client."""

    def __init__(self, address: str, access: Access, alone: bool) -> None:
        self.address = address
        self._metadata = access.metadata(address)
        options = channel_options(address)
        self.channel = (grpc.secure_channel(address, access.credentials(), options)
                        if access.encrypts else grpc.insecure_channel(address, options))
        self._stub: Any = remesh_pb2_grpc.RemeshServiceStub(self.channel)  # type: ignore
        # One that is alone is waited for; of several another one takes over what it left.
        self.stream = EditStream(
            lambda route, requests: self._stub.EditStream(requests, metadata=self._sent(route)),
            reconnects=alone)
        self.reached = False  # it has answered
        self.away_until = 0.0  # by time.monotonic()

    def call(self, method: str, request: Any, route: str = "") -> Any:
        return getattr(self._stub, method)(request, metadata=self._sent(route))

    def close(self) -> None:
        self.stream.cancel_all()
        self.channel.close()

    def _sent(self, route: str) -> list[tuple[str, str]]:
        key = hashlib.sha256(route.encode()).hexdigest()[:16]  # what a header may have
        return [*self._metadata, (_ROUTE, key)]


class Farm:
    """Which of them a request goes to.

    All requests of a loop have one route, and go to the replica that comes first for it by
    rendezvous hashing: it has the base in memory. Where it does not answer, the next in rank takes
    over, to whom the tier gives what it lacks; a request names all by id, so nothing is done twice.
    """

    def __init__(self, addresses: Sequence[str], access: Access, patience: float) -> None:
        """patience: s for which a request is tried again where none answers."""
        self.patience = patience
        self.replicas = [Replica(address, access, len(addresses) == 1) for address in addresses]

    @property
    def several(self) -> bool:
        return len(self.replicas) > 1

    def close(self) -> None:
        for replica in self.replicas:
            replica.close()


class Search:
    """The tries of one request."""

    def __init__(self, farm: Farm, route: str) -> None:
        self._farm = farm
        self._begun = time.monotonic()
        self._ranked = sorted(farm.replicas, reverse=True, key=lambda replica: hashlib.sha256(
            f"{replica.address}\n{route}".encode()).digest())

    def seconds(self) -> float:
        """Since it began."""
        return time.monotonic() - self._begun

    def replica(self) -> Replica:
        """The one to ask now."""
        now = time.monotonic()
        here = [replica for replica in self._ranked if replica.away_until <= now]
        return here[0] if here else min(self._ranked, key=lambda replica: replica.away_until)

    def goes_on(self, replica: Replica, error: RemeshError, broken: bool) -> bool:
        """Whether `replica()` is to be asked after this one failed; waits where all are away.

        broken: it did not answer. What one does not know another one may, that has not yet given
        it to the tier.
        """
        if not broken or error.reason not in (error.code, "STREAM_ENDED"):
            replica.reached = True  # it says so itself
        if error.reason == "REVISION_NOT_FOUND" and len(self._ranked) > 1:
            self._ranked.remove(replica)
        elif broken or (self._farm.several and error.code == "UNAVAILABLE"):
            pause = AWAY if self._farm.several else BETWEEN_TRIES
            replica.away_until = time.monotonic() + (pause if error.retry_after is None
                                                     else error.retry_after)
        else:
            return False
        wait = min(each.away_until for each in self._ranked) - time.monotonic()
        if wait <= 0:
            return True
        reached = any(each.reached for each in self._farm.replicas)
        if not reached or self.seconds() + wait > self._farm.patience:
            return False
        time.sleep(wait)
        return True
