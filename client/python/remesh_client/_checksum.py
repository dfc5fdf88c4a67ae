# SPDX-License-Identifier: Apache-2.0
"""CRC-32C of parts, and digests of arrays: SHA-256 over the SHA-256s of blocks of 16 KiB."""
from __future__ import annotations

import hashlib
from typing import Callable, cast

import numpy as np

from remesh_client._arrays import Array
from remesh_client._delta import Ints

BLOCK = 16384
_DIGEST = 32  # bytes of one block's

crc32c: Callable[[bytes], int]
try:  # the processor's instruction where there is one: several GB a second
    from crc32c import crc32c as _fast_crc32c
    crc32c = cast(Callable[[bytes], int], _fast_crc32c)
except ImportError:  # a table, in C: some 200 MB a second
    from crcmod.predefined import mkPredefinedCrcFun
    crc32c = cast(Callable[[bytes], int], mkPredefinedCrcFun("crc-32c"))


def _bytes_of(data: Array | bytes) -> memoryview:
    if not len(data):
        return memoryview(b"")
    return (memoryview(data) if isinstance(data, bytes) else data.data).cast("B")


def block_digests(data: Array | bytes) -> bytes:
    """The SHA-256s of the blocks, one after the other; empty for no bytes."""
    view = _bytes_of(data)
    sha256 = hashlib.sha256
    return b"".join([sha256(view[at:at + BLOCK]).digest() for at in range(0, len(view), BLOCK)])


def changed_digests(data: Array, base_bytes: int, base_digests: bytes,
                    changed: Ints, row_bytes: int) -> bytes:
    """As `block_digests`, but blocks that are the base's take its digests.

    changed: (k, 2) ranges of rows, outside of which the bytes are those of the base, an array of
    `base_bytes` bytes, at the same offset.
    """
    view = _bytes_of(data)
    count = -(-len(view) // BLOCK)
    first = np.bincount(changed[:, 0] * row_bytes // BLOCK, minlength=count + 1)
    end = np.bincount((changed[:, 1] * row_bytes - 1) // BLOCK + 1, minlength=count + 1)
    differs = np.cumsum(first - end)[:count] > 0
    if len(view) != base_bytes:
        differs[min(len(view), base_bytes) // BLOCK:] = True
    digests = bytearray(base_digests[:count * _DIGEST].ljust(count * _DIGEST, b"\0"))
    for block in np.flatnonzero(differs).tolist():
        at = block * BLOCK
        digests[block * _DIGEST:(block + 1) * _DIGEST] = hashlib.sha256(
            view[at:at + BLOCK]).digest()
    return bytes(digests)


def digest(blocks: bytes) -> str:
    """The digest of an array, 64 hexadecimal digits, of the digests of its blocks."""
    return hashlib.sha256(blocks).hexdigest()
