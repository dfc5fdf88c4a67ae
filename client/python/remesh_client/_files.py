# SPDX-License-Identifier: Apache-2.0
"""Mesh files as they come from the daemon."""
from __future__ import annotations

import hashlib
import os
from pathlib import Path

from remesh_client._checksum import crc32c
from remesh_client.errors import mesh_damaged
from remesh_client.v1 import mesh_pb2


class FileAssembler:
    """Takes the messages of one GetMeshFile in their order."""

    def __init__(self) -> None:
        self._header: mesh_pb2.MeshFileHeader | None = None
        self._pieces: list[bytes] = []
        self._size = 0

    def add(self, message: mesh_pb2.GetMeshFileResponse) -> None:
        """Raises MeshDamaged."""
        if message.HasField("header"):
            if self._header is not None:
                raise mesh_damaged("a second header")
            self._header = message.header
            return
        if self._header is None:
            raise mesh_damaged("a part comes before the header")
        data: bytes = message.part.data
        if message.part.offset != self._size:
            raise mesh_damaged("the file has a gap")
        if crc32c(data) != message.part.crc32c:
            raise mesh_damaged("wrong CRC-32C in a part of the file")
        self._pieces.append(data)
        self._size += len(data)

    def finish(self) -> bytes:
        """The file. Raises MeshDamaged where it is not complete or has another digest."""
        if self._header is None or self._size != self._header.bytes:
            raise mesh_damaged("the file is not complete")
        file = b"".join(self._pieces)
        if hashlib.sha256(file).hexdigest() != self._header.digest:
            raise mesh_damaged("wrong digest of the file")
        return file


def write_whole(path: os.PathLike[str] | str, data: bytes) -> Path:
    """The file appears whole or not at all. Raises OSError."""
    target = Path(path)
    if target.exists() and not target.is_file():  # a device or a pipe
        target.write_bytes(data)
        return target
    part = target.with_name(f"{target.name}.part{os.getpid()}")
    try:
        part.write_bytes(data)
        part.replace(target)
    except BaseException:
        part.unlink(missing_ok=True)
        raise
    return target
