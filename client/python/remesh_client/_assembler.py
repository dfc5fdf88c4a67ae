# SPDX-License-Identifier: Apache-2.0
"""A mesh put together from its messages. Everything is checked: order, CRC-32C of each part, the
digest of each array, counts, and all indices."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Iterable

import numpy as np
from google.protobuf.message import DecodeError

from remesh_client import _checksum
from remesh_client._arrays import Array, Kind, KNOWN, OPTIONAL, SECOND_ORDER, name_of
from remesh_client._checks import check_indices
from remesh_client._delta import apply_delta
from remesh_client.errors import mesh_damaged
from remesh_client.v1 import mesh_pb2

_Header = mesh_pb2.MeshHeader
_WHOLE, _SAME = int(_Header.ENCODING_WHOLE), int(_Header.ENCODING_SAME)
_DELTA = int(_Header.ENCODING_DELTA)


@dataclass
class Content:
    """The arrays of a mesh as they came: numbers read-only, text as its bytes."""

    header: _Header
    numbers: dict[int, Array] = field(default_factory=dict)
    texts: dict[int, bytes] = field(default_factory=dict)
    blocks: dict[int, bytes] = field(default_factory=dict)  # digests of the blocks of each array

    @property
    def revision(self) -> str:
        return self.header.revision

    def __getstate__(self) -> dict[str, Any]:
        """For pickling, which knows no messages."""
        return {**self.__dict__, "header": self.header.SerializeToString()}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state, header=_Header.FromString(state["header"]))
        for numbers in self.numbers.values():
            numbers.flags.writeable = False


class MeshAssembler:
    """Takes the messages of one mesh in their order; `content` once `ended`."""

    def __init__(self, wanted: Iterable[int] = (), base: Content | None = None) -> None:
        """wanted: numbers of the arrays asked for; none: all. base: what deltas are against."""
        self.ended = False
        self._wanted = set(wanted)
        self._base = base
        self._content: Content | None = None
        self._entries: list[_Header.Array] = []
        self._pieces: list[bytes] = []
        self._size = 0  # of the pieces
        self._bytes = self._parts = 0
        self.bytes_received = 0

    def add(self, message: mesh_pb2.MeshMessage) -> None:
        """Raises MeshDamaged."""
        if self.ended:
            raise mesh_damaged("something follows its end")
        what = message.WhichOneof("message")
        if what == "part":
            self._add_part(message.part)
        elif what == "header":
            self._add_header(message.header)
        elif what == "end":
            self._add_end(message.end)
        else:
            raise mesh_damaged("an empty message")

    @property
    def content(self) -> Content:
        """Raises MeshDamaged where it is not complete."""
        if not self.ended or self._content is None:
            raise mesh_damaged("its end is missing")
        return self._content

    def _add_header(self, header: _Header) -> None:
        if self._content is not None:
            raise mesh_damaged("a second header")
        self._content = Content(header)
        seen: set[int] = set()
        for entry in header.arrays:
            if entry.array in seen:
                raise mesh_damaged(f"{name_of(entry.array)} is announced twice")
            seen.add(entry.array)
            if entry.array in KNOWN:
                self._check_entry(entry, KNOWN[entry.array], header)
        self._check_base(header)
        for array in self._wanted or KNOWN:
            needed = array not in OPTIONAL and (array not in SECOND_ORDER or header.order == 2)
            if array in KNOWN and needed and array not in seen:
                raise mesh_damaged(f"{name_of(array)} is missing")
        self._entries = list(reversed(header.arrays))

    @staticmethod
    def _check_entry(entry: _Header.Array, kind: Kind, header: _Header) -> None:
        name = name_of(entry.array)
        if (entry.type, entry.components) != (kind.type, kind.components):
            raise mesh_damaged(f"{name} is of another type")
        if kind.rows and entry.count != getattr(header, kind.rows):
            raise mesh_damaged(f"{name} has the wrong count")
        if not kind.is_text and entry.bytes != entry.count * kind.components * kind.dtype.itemsize:
            raise mesh_damaged(f"{name} has another size than its rows")
        if entry.encoding == _WHOLE:
            if entry.data_bytes != entry.bytes:
                raise mesh_damaged(f"{name} is sent whole, but not all of it")
        elif entry.encoding == _SAME:
            if entry.data_bytes:
                raise mesh_damaged(f"{name} is sent although it is the base's")
        elif entry.encoding != _DELTA or kind.is_text:
            raise mesh_damaged(f"{name} has an encoding that is not known")

    def _check_base(self, header: _Header) -> None:
        needed = any(e.array in KNOWN and e.encoding != _WHOLE for e in header.arrays)
        here = self._base is not None and header.base and self._base.revision == header.base
        if needed and not here:
            raise mesh_damaged(f"it is a delta against the mesh of revision '{header.base}', "
                               "which is not here")

    def _add_part(self, part: mesh_pb2.MeshPart) -> None:
        if self._content is None:
            raise mesh_damaged("a part comes before the header")
        while self._entries and self._entries[-1].array != part.array:
            self._end_array()
        if not self._entries:
            raise mesh_damaged("a part of an array that is not expected now")
        data: bytes = part.data
        name = name_of(part.array)
        if part.offset != self._size:
            raise mesh_damaged(f"{name} has a gap")
        if self._size + len(data) > self._entries[-1].data_bytes:
            raise mesh_damaged(f"{name} is longer than announced")
        if _checksum.crc32c(data) != part.crc32c:
            raise mesh_damaged(f"wrong CRC-32C in part {self._parts} of {name}")
        self._pieces.append(data)
        self._size += len(data)
        self._bytes += len(data)
        self._parts += 1
        self.bytes_received += len(data)

    def _add_end(self, end: mesh_pb2.MeshEnd) -> None:
        if self._content is None:
            raise mesh_damaged("an end comes before the header")
        while self._entries:
            self._end_array()
        if (end.parts, end.bytes) != (self._parts, self._bytes):
            raise mesh_damaged("parts are missing")
        check_indices(self._content.header, self._content.numbers, self._content.texts)
        self.ended = True
        self._base = None

    def _end_array(self) -> None:
        """All of the current array has come: takes it and goes on to the next."""
        entry = self._entries.pop()
        if self._size != entry.data_bytes:
            raise mesh_damaged(f"{name_of(entry.array)} is not complete")
        data = self._pieces[0] if len(self._pieces) == 1 else b"".join(self._pieces)
        self._pieces = []
        self._size = 0
        kind = KNOWN.get(entry.array)
        if kind is None:
            return  # of a newer protocol
        assert self._content is not None
        if kind.is_text:
            self._take_text(entry, data, self._content)
        else:
            self._take_numbers(entry, kind, data, self._content)

    def _take_text(self, entry: _Header.Array, data: bytes, content: Content) -> None:
        if entry.encoding == _SAME:
            assert self._base is not None
            data = self._base.texts.get(entry.array, b"")
        blocks = _checksum.block_digests(data)
        if len(data) != entry.bytes or _checksum.digest(blocks) != entry.digest:
            raise mesh_damaged(f"wrong digest of {name_of(entry.array)}")
        if data.count(b"\n") != entry.count or (data and not data.endswith(b"\n")):
            raise mesh_damaged(f"{name_of(entry.array)} has the wrong count")
        content.texts[entry.array], content.blocks[entry.array] = data, blocks

    def _take_numbers(self, entry: _Header.Array, kind: Kind, data: bytes,
                      content: Content) -> None:
        array, name = entry.array, name_of(entry.array)
        base = None if self._base is None else self._base.numbers.get(array)
        if entry.encoding == _WHOLE:
            numbers = np.frombuffer(data, kind.dtype)
            if kind.components > 1:
                numbers = numbers.reshape(-1, kind.components)
        elif base is None:
            raise mesh_damaged(f"{name} is a delta, and the base has no such array")
        elif entry.encoding == _SAME:
            numbers = base
        else:
            rebuilt = apply_delta(_delta_of(data, name), kind, entry.count, base)
            numbers = rebuilt.array
        if entry.encoding == _WHOLE or base is None or self._base is None:
            blocks = _checksum.block_digests(numbers)
        elif entry.encoding == _SAME:
            blocks = self._base.blocks[array]
        else:
            blocks = _checksum.changed_digests(
                numbers, base.nbytes, self._base.blocks[array], rebuilt.changed,
                kind.components * kind.dtype.itemsize)
        if len(numbers) != entry.count or _checksum.digest(blocks) != entry.digest:
            raise mesh_damaged(f"wrong digest of {name}")
        numbers.flags.writeable = False
        content.numbers[array], content.blocks[array] = numbers, blocks


def _delta_of(data: bytes, name: str) -> mesh_pb2.ArrayDelta:
    delta = mesh_pb2.ArrayDelta()
    try:
        delta.ParseFromString(data)
    except DecodeError:
        raise mesh_damaged(f"the delta of {name} cannot be read") from None
    return delta


def assemble(messages: Iterable[mesh_pb2.MeshMessage], base: Content | None = None) -> Content:
    """A whole mesh of its messages. Raises MeshDamaged."""
    assembler = MeshAssembler(base=base)
    for message in messages:
        assembler.add(message)
    return assembler.content
