# SPDX-License-Identifier: Apache-2.0
"""Which of several daemons a request goes to, and where it goes when that one fails.

All requests of a loop have one route, and go to the replica that comes first for it by rendezvous
hashing: it has the base in memory. Where it does not answer, the next in rank takes over, to whom
the tier gives what it lacks; a request names all by id, so nothing is done twice. One daemon alone
is a list of one.
"""
from __future__ import annotations

import hashlib
import time
from typing import Generic, Sequence, TypeVar

from remesh_client._connection import Access
from remesh_client.errors import RemeshError

PATIENCE = 30.0  # s for which a request is tried again where no daemon is available
AWAY = 1.0  # s for which a replica that did not answer is passed over
BETWEEN_TRIES = 0.2  # s, of one daemon alone
_ROUTE = "x-remesh-key"  # by which a balancer in between sends all of a loop to one replica


class Peer:
    """One daemon: its address, what every call to it sends, and whether it answers."""

    def __init__(self, address: str, access: Access) -> None:
        self.address = address
        self._metadata = access.metadata(address)
        self.reached = False  # it has answered
        self.away_until = 0.0  # by time.monotonic()

    def sent(self, route: str) -> list[tuple[str, str]]:
        """The metadata of a call."""
        key = hashlib.sha256(route.encode()).hexdigest()[:16]  # what a header may have
        return [*self._metadata, (_ROUTE, key)]


P = TypeVar("P", bound=Peer)


class Peers(Generic[P]):
    """Those that a client may ask: one, or the replicas of a farm that share a tier."""

    def __init__(self, replicas: Sequence[P], patience: float) -> None:
        self.replicas = replicas
        self.patience = patience
        self.homes: dict[str, P] = {}  # by route: who said that the design's names are there

    @property
    def several(self) -> bool:
        return len(self.replicas) > 1


class Search(Generic[P]):
    """The tries of one request."""

    def __init__(self, peers: Peers[P], route: str) -> None:
        self._peers, self._route = peers, route
        self._begun = time.monotonic()
        self._failed: float | None = None  # when it did first
        self._sent_home = False
        home = peers.homes.get(route)
        self._ranked = sorted(peers.replicas, reverse=True, key=lambda replica: (
            replica is home, hashlib.sha256(f"{replica.address}\n{route}".encode()).digest()))

    def seconds(self) -> float:
        """Since it began."""
        return time.monotonic() - self._begun

    def replica(self) -> P:
        """The one to ask now."""
        now = time.monotonic()
        here = [replica for replica in self._ranked if replica.away_until <= now]
        return here[0] if here else min(self._ranked, key=lambda replica: replica.away_until)

    def delay(self, replica: P, error: RemeshError, broken: bool) -> float | None:
        """Seconds to wait before `replica()` is asked, after `replica` failed with `error`; None:
        do not try again, raise the error.

        broken: the connection broke, without an answer. After REVISION_NOT_FOUND the other replicas
        are asked too: one of them may have the revision and not have written it to the tier yet.
        """
        now = time.monotonic()
        self._failed = self._failed or now
        if (not broken or error.code != "UNAVAILABLE"
                or error.reason not in (error.code, "STREAM_ENDED")):
            replica.reached = True  # it, or a balancer, says so itself
        if error.reason == "DESIGN_ELSEWHERE":
            return 0.0 if self._goes_home(error.home) else None
        if error.reason == "REVISION_NOT_FOUND" and len(self._ranked) > 1:
            self._ranked.remove(replica)
        elif broken or (self._peers.several and error.code == "UNAVAILABLE"):
            pause = AWAY if self._peers.several else BETWEEN_TRIES
            replica.away_until = now + (pause if error.retry_after is None else error.retry_after)
        else:
            return None
        wait = min(each.away_until for each in self._ranked) - now
        if wait <= 0:
            return 0.0
        reached = any(each.reached for each in self._peers.replicas)
        return wait if reached and now + wait - self._failed <= self._peers.patience else None

    def _goes_home(self, address: str) -> bool:
        """Asks the home of the design alone from now on; once, and only one that it knows."""
        home = next((each for each in self._peers.replicas if each.address == address), None)
        if home is None or self._sent_home:
            return False
        self._sent_home = True
        self._peers.homes[self._route] = home
        self._ranked = [home]
        return True


def is_name(revision: str) -> bool:
    """Whether it names a revision by its design; else it is an id, or the beginning of one."""
    return "@" in revision or len(revision) < 8 or bool(set(revision) - set("0123456789abcdef"))


def route_of(revision: str) -> str:
    """The route of what asks for a revision: its design. Of an id nothing is known, so that any
    daemon is asked."""
    return revision.split("@", 1)[0] if is_name(revision) else ""
