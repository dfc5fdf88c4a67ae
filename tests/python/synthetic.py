"""Messages of meshes that no daemon made."""
import hashlib

import crcmod.predefined
import numpy as np

from remesh_client._arrays import KNOWN
from remesh_client.v1 import mesh_pb2 as pb

crc32c = crcmod.predefined.mkPredefinedCrcFun("crc-32c")  # not the one that the client takes
BLOCK = 16384


def digest(data):
    """As mesh.proto has it, written a second time."""
    blocks = [hashlib.sha256(data[at:at + BLOCK]).digest() for at in range(0, len(data), BLOCK)]
    return hashlib.sha256(b"".join(blocks)).hexdigest()


class MeshMessages:
    """Header, parts and end of some arrays, each whole unless it is told otherwise."""

    def __init__(self, revision="rev-1", base="", part_bytes=1 << 20, **header):
        self.header = pb.MeshHeader(revision=revision, base=base, order=1, **header)
        self.data = []  # of each array, as sent
        self.part_bytes = part_bytes

    def add(self, array, values, encoding=pb.MeshHeader.ENCODING_WHOLE, sent=None):
        """values: the array once received; sent: the bytes that travel, where they are others."""
        kind = KNOWN[array]
        if kind.is_text:
            whole, count = values.encode(), values.count("\n")
        else:
            values = np.asarray(values, kind.dtype)
            whole, count = values.tobytes(), values.size // kind.components
        data = whole if sent is None else sent
        self.header.arrays.add(array=array, type=kind.type, components=kind.components,
                               count=count, bytes=len(whole), digest=digest(whole),
                               encoding=encoding, data_bytes=len(data))
        self.data.append((array, data))
        return self

    def messages(self):
        out = [pb.MeshMessage(header=self.header)]
        total = 0
        for array, data in self.data:
            for at in range(0, len(data), self.part_bytes):
                piece = data[at:at + self.part_bytes]
                out.append(pb.MeshMessage(part=pb.MeshPart(array=array, offset=at, data=piece,
                                                           crc32c=crc32c(piece))))
                total += len(piece)
        out.append(pb.MeshMessage(end=pb.MeshEnd(bytes=total, parts=len(out) - 1)))
        return out


POINTS = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]
TETS = [[0, 1, 2, 3], [1, 2, 3, 4]]


def two_tets(**header):
    """Two tets on a common facet, with what a daemon of this version sends of them."""
    sent = MeshMessages(nodes=5, tets=2, facets=3, **header)
    sent.add(pb.MESH_ARRAY_NODES, POINTS).add(pb.MESH_ARRAY_TETS, TETS)
    sent.add(pb.MESH_ARRAY_NODE_IDS, range(10, 15)).add(pb.MESH_ARRAY_TET_IDS, [7, 8])
    sent.add(pb.MESH_ARRAY_FACETS, [[0, 2, 1], [0, 1, 3], [1, 2, 4]])
    sent.add(pb.MESH_ARRAY_FACET_TETS, [0, 0, 1]).add(pb.MESH_ARRAY_FACET_GROUP, [0, 1, 0])
    sent.add(pb.MESH_ARRAY_FACET_GROUPS, "plate.bottom\nhole.wall plate.top\n")
    sent.add(pb.MESH_ARRAY_TET_CELLS, [0, 1]).add(pb.MESH_ARRAY_CELL_OWNERS, "plate\nplate rib\n")
    sent.add(pb.MESH_ARRAY_NODE_ORIGINS, [0] * 5).add(pb.MESH_ARRAY_ORIGINAL_NODES, [-1] * 5)
    sent.add(pb.MESH_ARRAY_NODE_TRANSFORMS, [-1] * 5)
    sent.add(pb.MESH_ARRAY_TRANSFORMS, np.empty((0, 12)))
    sent.add(pb.MESH_ARRAY_TRANSFORM_FEATURES, "")
    return sent.add(pb.MESH_ARRAY_ORIGINAL_TETS, [-1, -1])
