# SPDX-License-Identifier: Apache-2.0
"""Results of CalculiX: its file .frd, in text."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

_COMPONENTS = {"DISP": 3, "STRESS": 6}
_WIDTH = 12  # characters of a number
_NODE = slice(3, 13)


def read_frd(path: Path, nodes: int) -> dict[str, npt.NDArray[np.float64]]:
    """Fields at nodes of the last step by name: `DISP` (nodes, 3), `STRESS` (nodes, 6) in the order
    xx yy zz xy yz zx. A node that the file does not tell of has NaN. Raises OSError."""
    fields: dict[str, npt.NDArray[np.float64]] = {}
    field: npt.NDArray[np.float64] | None = None
    components = 0
    with open(path, encoding="ascii", errors="replace") as lines:
        for line in lines:
            key = line[:3]
            if key == " -4":
                name = line[5:13].strip()
                components = _COMPONENTS.get(name, 0)
                field = np.full((nodes, components), np.nan) if components else None
                if field is not None:
                    fields[name] = field
            elif key == " -1" and field is not None:
                node = int(line[_NODE])
                if node <= nodes:
                    field[node - 1] = [_number(line[13 + _WIDTH * k:13 + _WIDTH * (k + 1)])
                                       for k in range(components)]
            elif key == " -3":
                field = None
    return fields


def _number(text: str) -> float:
    """Fortran drops the E of an exponent with three digits."""
    try:
        return float(text)
    except ValueError:
        return float(text[:-4] + "E" + text[-4:]) if text[-4:-3] in "+-" else float("nan")
