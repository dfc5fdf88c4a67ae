# SPDX-License-Identifier: Apache-2.0
"""The daemons that the client for asyncio may ask."""
from __future__ import annotations

from typing import Any, Sequence

import grpc.aio

from remesh_client._aio_stream import EditStream
from remesh_client._connection import Access, channel_options
from remesh_client._search import Peer, Peers
from remesh_client.v1 import remesh_pb2_grpc


class Replica(Peer):
    """One daemon, its channel and the stream of this client."""

    def __init__(self, address: str, access: Access) -> None:
        super().__init__(address, access)
        options = channel_options(address)
        self._channel = (grpc.aio.secure_channel(address, access.credentials(), options)
                         if access.encrypts else grpc.aio.insecure_channel(address, options))
        self._stub: Any = remesh_pb2_grpc.RemeshServiceStub(self._channel)  # type: ignore
        self.stream = EditStream(lambda route: self._stub.EditStream(metadata=self.sent(route)))

    def call(self, method: str, request: Any, route: str) -> Any:
        """To be awaited, or an asynchronous iterator where the daemon answers with messages."""
        return getattr(self._stub, method)(request, metadata=self.sent(route))

    async def close(self) -> None:
        await self.stream.cancel_all()
        await self._channel.close()


class Farm(Peers[Replica]):
    """Replicas and their streams, for one event loop."""

    def __init__(self, addresses: Sequence[str], access: Access, patience: float) -> None:
        """patience: s for which a request is tried again where none answers."""
        super().__init__([Replica(address, access) for address in addresses], patience)

    async def close(self) -> None:
        for replica in self.replicas:
            await replica.close()
