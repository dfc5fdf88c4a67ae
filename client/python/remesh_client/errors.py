# SPDX-License-Identifier: Apache-2.0
"""What goes wrong, as exceptions that say where and what would help."""
from __future__ import annotations

from typing import Any

import grpc

from remesh_client.v1 import error_pb2, rpc_status_pb2

Error = error_pb2.Error
Point = tuple[float, float, float]


class RemeshError(Exception):
    """A request that failed. Subclasses stand for the codes that a program treats apart.

    Attributes:
        code: the code of gRPC, `INVALID_ARGUMENT`.
        reason: a stable name, `VALUE_OUT_OF_RANGE`; error.proto lists all with what to do.
        message: one sentence.
        hint: what would help; may be empty.
        stage: `request`, `document`, `transfer` or the station of the engine; may be empty.
        features: ids of the features at fault, the first foremost.
        parameter: the parameter or option at fault; may be empty.
        points: places, x y z in the model's unit each.
        edit_index: index of the edit at fault, from 0; None where it is none of them.
        line, column: place in the document, from 1; None where there is none.
        retry_after: seconds after which the same request may go well; None: waiting does not help.
        attempts: what was tried for a mesh, in order, each with its reason.
        home: address of the daemon to ask instead, where this one has not the design; may be empty.
    """

    def __init__(self, error: Error, document: str = "") -> None:
        self.code: str = _code_name(error.code)
        self.reason: str = _reason_name(error)
        self.message: str = error.message or self.code
        self.hint: str = error.hint
        self.stage: str = error.stage
        self.features: tuple[str, ...] = tuple(error.features)
        self.parameter: str = error.parameter
        self.points: tuple[Point, ...] = _points(error)
        self.edit_index: int | None = _optional(error, "edit_index")
        self.line: int | None = _optional(error, "line")
        self.column: int | None = _optional(error, "column")
        self.retry_after: float | None = _optional(error, "retry_after")
        self.attempts: tuple[str, ...] = tuple(error.attempts)
        self.home: str = error.home
        self.document = document  # the file that the request was read from
        super().__init__(self._text())

    def _text(self) -> str:
        text = self.message
        if self.document and self.line is not None:
            text = f"{self.document}:{self.line}:{self.column or 1}: {text}"
        told: list[str] = [f"feature {name}" for name in self.features if name not in text]
        if self.parameter and self.parameter not in text:
            told.append(f"parameter {self.parameter}")
        if self.home and self.home not in text:
            told.append(f"daemon {self.home}")
        for x, y, z in self.points:
            told.append(f"at ({x:.9g}, {y:.9g}, {z:.9g})")
        where = f" [{', '.join(told)}]" if told else ""
        hint = f" ({self.hint})" if self.hint else ""
        return f"{text}{where}{hint}"

    def __reduce__(self) -> tuple[Any, ...]:
        return (_plain_copy, (type(self), dict(self.__dict__), str(self)))


class InvalidRequest(RemeshError):
    """The model, edit or option cannot be right: INVALID_ARGUMENT, OUT_OF_RANGE."""


class NotFound(RemeshError):
    """No such revision, design or feature."""


class MeshingFailed(RemeshError):
    """This model cannot be meshed, or the state forbids it: FAILED_PRECONDITION."""


class Busy(RemeshError):
    """Busy or full: after `retry_after` seconds the same request may go well."""


class Conflict(RemeshError):
    """The head of the design is another one by now: ABORTED."""


class Cancelled(RemeshError):
    """The request was cancelled."""


class DeadlineExceeded(RemeshError):
    """The time given to the request, or the daemon's own limit, has passed."""


class Unavailable(RemeshError):
    """The daemon is not there, does not start, or is about to end."""


class Denied(RemeshError):
    """Without or with unknown credentials, or not allowed."""


class Unsupported(RemeshError):
    """A call or field that this daemon does not do; `parameter` names it."""


class MeshDamaged(RemeshError):
    """A mesh that arrived with a wrong checksum, digest, count or index: DATA_LOSS."""


_CLASSES: dict[int, type[RemeshError]] = {
    Error.CODE_INVALID_ARGUMENT: InvalidRequest,
    Error.CODE_OUT_OF_RANGE: InvalidRequest,
    Error.CODE_NOT_FOUND: NotFound,
    Error.CODE_FAILED_PRECONDITION: MeshingFailed,
    Error.CODE_RESOURCE_EXHAUSTED: Busy,
    Error.CODE_ABORTED: Conflict,
    Error.CODE_CANCELLED: Cancelled,
    Error.CODE_DEADLINE_EXCEEDED: DeadlineExceeded,
    Error.CODE_UNAVAILABLE: Unavailable,
    Error.CODE_UNAUTHENTICATED: Denied,
    Error.CODE_PERMISSION_DENIED: Denied,
    Error.CODE_UNIMPLEMENTED: Unsupported,
    Error.CODE_DATA_LOSS: MeshDamaged,
}


def from_error(error: Error, document: str = "") -> RemeshError:
    """The exception for an Error of the protocol; `document`: the file of its lines."""
    return _CLASSES.get(error.code, RemeshError)(error, document)


def error_of_rpc(failure: grpc.RpcError) -> Error:
    """The Error in the details of a call that failed, else one of its code and message."""
    code = failure.code()
    for key, value in failure.trailing_metadata() or ():
        if key == "grpc-status-details-bin":
            found = _detail(value)
            if found is not None:
                return found
    number = code.value[0] if code is not None else 2
    return Error(code=number, message=failure.details() or "")


def from_rpc(failure: grpc.RpcError) -> RemeshError:
    """The exception for a call that failed."""
    return from_error(error_of_rpc(failure))


def made_here(code: Any, message: str, reason: Any = 0, hint: str = "") -> RemeshError:
    """An exception of the client's own, like the daemon's."""
    return from_error(Error(code=code, reason=reason, message=message, hint=hint))


def mesh_damaged(what: str) -> RemeshError:
    """`what` is wrong with a mesh as it arrived."""
    return from_error(Error(code=Error.CODE_DATA_LOSS, reason=Error.MESH_DAMAGED,
                            stage="transfer", message=f"the mesh arrived damaged: {what}",
                            hint="fetch it again, whole"))


def _detail(value: bytes) -> Error | None:
    status = rpc_status_pb2.RpcStatus()
    try:
        status.ParseFromString(value)
    except Exception:  # not ours: a proxy's, or cut
        return None
    error = Error()
    for detail in status.details:
        if detail.Unpack(error):
            return error
    return None


def _code_name(code: int) -> str:
    try:
        name: str = Error.Code.Name(code)
    except ValueError:
        return "UNKNOWN"
    return name.removeprefix("CODE_")


def _reason_name(error: Error) -> str:
    try:
        name: str = Error.Reason.Name(error.reason)
    except ValueError:
        name = ""
    return name if error.reason and name else _code_name(error.code)


def _points(error: Error) -> tuple[Point, ...]:
    values = list(error.point)
    return tuple((values[k], values[k + 1], values[k + 2]) for k in range(0, len(values) - 2, 3))


def _optional(error: Error, field: str) -> Any:
    return getattr(error, field) if error.HasField(field) else None


def _plain_copy(kind: type[RemeshError], state: dict[str, Any], text: str) -> RemeshError:
    """For pickling: processes of a pool hand exceptions on."""
    made = kind.__new__(kind)
    Exception.__init__(made, text)
    made.__dict__.update(state)
    return made
