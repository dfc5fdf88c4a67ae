# SPDX-License-Identifier: Apache-2.0
"""An array made of the base's array of the same name and an ArrayDelta."""
from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from remesh_client._arrays import Array, Kind, U64
from remesh_client.errors import mesh_damaged
from remesh_client.v1 import mesh_pb2

_Delta = mesh_pb2.ArrayDelta
_COPY, _ROWS = int(_Delta.KIND_COPY), int(_Delta.KIND_ROWS)
_REPEAT, _COUNT = int(_Delta.KIND_REPEAT), int(_Delta.KIND_COUNT)
Ints = npt.NDArray[np.int64]


def ranges(firsts: Ints, counts: Ints) -> Ints:
    """first, first + 1, ..., `count` numbers of each range, one after the other."""
    before = np.cumsum(counts) - counts
    steps: Ints = np.arange(int(counts.sum()), dtype=np.int64)
    steps += np.repeat(firsts - before, counts)
    return steps


class Rebuilt(NamedTuple):
    """An array, and where its bytes may differ from those of the base at the same offset."""

    array: Array
    changed: Ints  # (k, 2) ranges of rows, first and end, ascending


def apply_delta(delta: _Delta, kind: Kind, count: int, base: Array) -> Rebuilt:
    """The array, `count` rows of the kind's type and components.

    base: rows of the same kind. Raises MeshDamaged where the delta is wrong; no room is taken
    before its number of rows has been checked.
    """
    kinds, counts, starts = (np.fromiter(numbers[:], np.int64, len(numbers))
                             for numbers in (delta.kinds, delta.counts, delta.starts))
    _check_runs(kinds, counts, starts, kind, count)
    ends = np.cumsum(counts)
    firsts = ends - counts
    shape = (count, kind.components) if kind.components > 1 else (count,)
    out = np.empty(shape, kind.dtype)
    _copy(out, base, firsts, counts, starts, kinds == _COPY)
    _place_rows(out, delta.rows, kind, kinds, firsts, counts)
    _count_up(out, firsts, counts, starts, kinds == _COUNT)
    changed = (kinds != _COPY) | (starts != 0)
    return Rebuilt(out, np.column_stack([firsts[changed], ends[changed]]))


def _check_runs(kinds: Ints, counts: Ints, starts: Ints, kind: Kind, count: int) -> None:
    if not len(kinds) == len(counts) == len(starts):
        raise mesh_damaged("the lists of a delta differ in length")
    if int(counts.sum()) != count:
        raise mesh_damaged("a delta has the wrong number of rows")
    if not len(kinds):
        return
    if int(counts.min()) == 0:
        raise mesh_damaged("a delta has an empty run")
    if int(kinds.min()) < _COPY or int(kinds.max()) > _COUNT:
        raise mesh_damaged("a delta has a run of a kind that is not known")
    if starts[(kinds == _ROWS) | (kinds == _REPEAT)].any():
        raise mesh_damaged("a run of rows has a start")
    if (kinds == _COUNT).any() and (kind.components != 1 or kind.dtype.kind == "f"):
        raise mesh_damaged("a delta counts where there are no single whole numbers")


def _copy(out: Array, base: Array, firsts: Ints, counts: Ints, starts: Ints,
          copied: npt.NDArray[np.bool_]) -> None:
    to, size, start = firsts[copied], counts[copied], starts[copied]
    rows = len(base)
    if ((start < -to) | (start > rows - to - size)).any():
        raise mesh_damaged("a delta copies rows that are not there")
    common = min(len(out), rows)
    out[:common] = base[:common]  # most rows are where they were
    moved = start != 0
    if moved.any():
        at = ranges(to[moved], size[moved])
        _by_row(out)[at] = _by_row(base)[at + np.repeat(start[moved], size[moved])]


def _place_rows(out: Array, rows: bytes, kind: Kind, kinds: Ints, firsts: Ints,
                counts: Ints) -> None:
    placed, repeated = kinds == _ROWS, kinds == _REPEAT
    used = np.where(placed, counts, repeated)
    if int(used.sum()) * kind.dtype.itemsize * kind.components != len(rows):
        raise mesh_damaged("a delta lacks rows or has some that no run uses")
    if not rows:
        return
    own = _by_row(np.frombuffer(rows, kind.dtype).reshape(-1, kind.components))
    out = _by_row(out)
    if not repeated.any():
        out[ranges(firsts[placed], counts[placed])] = own
        return
    first_own = np.cumsum(used) - used
    if placed.any():
        out[ranges(firsts[placed], counts[placed])] = own[ranges(first_own[placed],
                                                                 counts[placed])]
    out[ranges(firsts[repeated], counts[repeated])] = own[np.repeat(first_own[repeated],
                                                                    counts[repeated])]


def _by_row(array: Array) -> Array:
    """The same memory with a number for each row, which numpy moves several times faster."""
    row_bytes = array.itemsize * (array.shape[1] if array.ndim == 2 else 1)
    return array.view(_NUMBERS.get(row_bytes, f"V{row_bytes}")).reshape(-1)


_NUMBERS = {1: "u1", 4: "<u4", 8: "<u8", 16: "<c16"}


def _count_up(out: Array, firsts: Ints, counts: Ints, starts: Ints,
              counted: npt.NDArray[np.bool_]) -> None:
    if not counted.any():
        return
    to, size, start = firsts[counted], counts[counted], starts[counted]
    at = ranges(to, size)
    if out.dtype == U64:
        first = to.astype(np.uint64) + start.view(np.uint64)  # modulo 2^64
        if (first > np.uint64(2**64 - 1) - (size - 1).astype(np.uint64)).any():
            raise mesh_damaged("a delta counts too far")
        out[at] = at.astype(np.uint64) + np.repeat(start.view(np.uint64), size)
        return
    limits = np.iinfo(out.dtype)
    if ((start < limits.min - to) | (start > limits.max - to - (size - 1))).any():
        raise mesh_damaged("a delta counts too far")
    out[at] = at + np.repeat(start, size)
