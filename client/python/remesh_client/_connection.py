# SPDX-License-Identifier: Apache-2.0
"""Channels to a daemon, for the synchronous client and the asynchronous one."""
from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Sequence

import grpc

from remesh_client.errors import Error, made_here

DEFAULT_ADDRESS = "127.0.0.1:50051"
_MAX_MESSAGE = 256 << 20  # bytes: models are the largest single messages
_KEEPALIVE_MS, _KEEPALIVE_TIMEOUT_MS = 30_000, 20_000
_RECONNECT_MS = 200, 2_000  # between tries of a daemon that is started again


@dataclass(frozen=True)
class Access:
    """How to reach a daemon: PEM files, and a token that speaks for a tenant.

    tls_ca: who signed the daemon's certificate. tls_cert, tls_key: the client's own. token_file:
    a file with the token in its first line.
    """

    tls_ca: os.PathLike[str] | str | None = None
    tls_cert: os.PathLike[str] | str | None = None
    tls_key: os.PathLike[str] | str | None = None
    token_file: os.PathLike[str] | str | None = None

    @property
    def encrypts(self) -> bool:
        return self.tls_ca is not None or self.tls_cert is not None

    def credentials(self) -> grpc.ChannelCredentials:
        """Raises OSError where a file cannot be read."""
        ca, key, cert = (None if path is None else Path(path).read_bytes()
                         for path in (self.tls_ca, self.tls_key, self.tls_cert))
        return grpc.ssl_channel_credentials(ca, key, cert)

    def metadata(self, address: str) -> list[tuple[str, str]]:
        """What every call sends. A token is as good as a password: it never goes in the clear to
        another machine; raises InvalidRequest instead."""
        if self.token_file is None:
            return []
        if not self.encrypts and not is_here(address):
            raise made_here(Error.CODE_INVALID_ARGUMENT,
                            f"a token would be sent to {address} for anyone to read",
                            hint="use TLS: tls_ca=FILE")
        token = Path(self.token_file).read_text(encoding="utf-8").split("\n", 1)[0].strip()
        return [("authorization", f"Bearer {token}")]


def is_loopback(address: str) -> bool:
    return address.startswith(("127.", "localhost:", "[::1]:"))


def is_here(address: str) -> bool:
    """Whether it is on this machine."""
    return is_loopback(address) or address.startswith("unix:")


def channel_options(address: str) -> list[tuple[str, Any]]:
    """The options of a channel: as in C++, but with a keepalive ping every 30 s instead of 60."""
    options: list[tuple[str, Any]] = [
        ("grpc.keepalive_time_ms", _KEEPALIVE_MS),
        ("grpc.keepalive_timeout_ms", _KEEPALIVE_TIMEOUT_MS),
        ("grpc.initial_reconnect_backoff_ms", _RECONNECT_MS[0]),
        ("grpc.min_reconnect_backoff_ms", _RECONNECT_MS[0]),
        ("grpc.max_reconnect_backoff_ms", _RECONNECT_MS[1]),
        ("grpc.max_receive_message_length", _MAX_MESSAGE)]
    if is_loopback(address):  # a proxy of the environment would be asked even for the way here
        options.append(("grpc.enable_http_proxy", 0))
    return options


def addresses_or_default(address: str | Sequence[str] | None) -> list[str]:
    """Those of a list or a text with commas, each once; those of REMESH_ADDRESS where none is
    given, else the one that a daemon has by default. Raises ValueError where there is none in it,
    or `local` among others."""
    if address is None or isinstance(address, str):
        address = (address or os.environ.get("REMESH_ADDRESS") or DEFAULT_ADDRESS).split(",")
    addresses = list(dict.fromkeys(each.strip() for each in address if each.strip()))
    if not addresses:
        raise ValueError("no address is given")
    if "local" in addresses[1:] or addresses[0] == "local" and len(addresses) > 1:
        raise ValueError("`local` stands for a daemon of its own: it cannot be one of several")
    return addresses
