"""Daemons that mesh nothing: what they are asked is noted, what they answer is set by the test."""
import hashlib
from concurrent import futures

import grpc

from remesh_client._checksum import crc32c
from remesh_client.v1 import (error_pb2, mesh_pb2, remesh_pb2_grpc, revision_pb2, rpc_status_pb2,
                              stream_pb2)

Error = error_pb2.Error
ENDS = "the stream ends well, without an answer"


def error(code, reason=0, **fields):
    return Error(code=code, reason=reason, message="told by the test", **fields)


class FakeDaemon(remesh_pb2_grpc.RemeshServiceServicer):
    """failures: of the next calls and requests, an Error each, or (code of gRPC, message[, trailing
    metadata]) for what breaks the call; None: none. A call to GetMeshFile breaks after its first
    part."""

    def __init__(self):
        self.failures = []
        self.always = None  # once `failures` are used up
        self.keys = []  # what came as x-remesh-key
        self.file = b"*NODE\n1, 0, 0, 0\n"
        self._server = grpc.server(futures.ThreadPoolExecutor(64))
        remesh_pb2_grpc.add_RemeshServiceServicer_to_server(self, self._server)
        self.address = f"127.0.0.1:{self._server.add_insecure_port('127.0.0.1:0')}"
        self._server.start()

    @property
    def asked(self):
        return len(self.keys)

    def stop(self):
        self._server.stop(None).wait()

    def _failure(self):
        return self.failures.pop(0) if self.failures else self.always

    def _note(self, context):
        self.keys.append(dict(context.invocation_metadata())["x-remesh-key"])

    def _abort(self, failure, context):
        if isinstance(failure, tuple):
            context.set_trailing_metadata(sum(failure[2:], ()))
            context.abort(*failure[:2])
        status = rpc_status_pb2.RpcStatus(code=failure.code, message=failure.message)
        status.details.add().Pack(failure)
        context.set_trailing_metadata((("grpc-status-details-bin", status.SerializeToString()),))
        context.abort(next(each for each in grpc.StatusCode if each.value[0] == failure.code),
                      failure.message)

    def EditStream(self, requests, context):
        for request in requests:
            self._note(context)
            made = request.edit if request.HasField("edit") else request.create
            failure = self._failure()
            if failure == ENDS:
                return
            if isinstance(failure, tuple):
                self._abort(failure, context)
            answer = stream_pb2.EditStreamResponse(request_id=made.request_id)
            if failure is not None:
                answer.error.CopyFrom(failure)
            else:
                answer.result.revision.CopyFrom(revision_pb2.RevisionInfo(
                    id=hashlib.sha256(made.request_id.encode()).hexdigest(),
                    design=made.design or "bracket", root="0" * 64))
            yield answer

    def GetRevision(self, request, context):
        self._note(context)
        failure = self._failure()
        if failure is not None:
            self._abort(failure, context)
        return revision_pb2.GetRevisionResponse(revision=revision_pb2.RevisionInfo(
            id="1" * 64, root="0" * 64, design=request.revision.split("@")[0]))

    def GetMeshFile(self, request, context):
        self._note(context)
        failure = self._failure()
        half = len(self.file) // 2
        yield mesh_pb2.GetMeshFileResponse(header=mesh_pb2.MeshFileHeader(
            revision=request.revision, bytes=len(self.file),
            digest=hashlib.sha256(self.file).hexdigest()))
        for begin, end in ((0, half), (half, len(self.file))):
            if begin and failure is not None:
                self._abort(failure, context)
            data = self.file[begin:end]
            yield mesh_pb2.GetMeshFileResponse(part=mesh_pb2.MeshFilePart(
                offset=begin, data=data, crc32c=crc32c(data)))
