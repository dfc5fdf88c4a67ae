"""Meshes are rebuilt from their messages to the bit, or refused."""
import numpy as np
import pytest

import remesh_client as rc
from remesh_client import _checksum
from remesh_client._arrays import F64, I32, KNOWN, Kind, U64, U8
from remesh_client._assembler import assemble
from remesh_client._delta import apply_delta
from remesh_client.v1 import mesh_pb2 as pb
from synthetic import MeshMessages, crc32c, digest, two_tets

COPY, ROWS = pb.ArrayDelta.KIND_COPY, pb.ArrayDelta.KIND_ROWS
REPEAT, COUNT = pb.ArrayDelta.KIND_REPEAT, pb.ArrayDelta.KIND_COUNT


def kind(dtype, components=1):
    types = {F64: pb.ARRAY_TYPE_F64, I32: pb.ARRAY_TYPE_I32, U64: pb.ARRAY_TYPE_U64,
             U8: pb.ARRAY_TYPE_U8}
    return Kind(types[np.dtype(dtype)], components, "")


def delta(*runs, rows=b""):
    """runs: (kind, count, start)."""
    return pb.ArrayDelta(kinds=[run[0] for run in runs], counts=[run[1] for run in runs],
                         starts=[run[2] for run in runs], rows=rows)


def test_a_mesh_has_its_arrays_names_and_sets():
    mesh = rc.Mesh(assemble(two_tets().messages()))
    assert mesh.points.shape == (5, 3) and mesh.points[4].tolist() == [1, 1, 1]
    assert mesh.tets.dtype == np.int32 and mesh.tets.tolist() == [[0, 1, 2, 3], [1, 2, 3, 4]]
    assert mesh.ids.tolist() == [10, 11, 12, 13, 14]
    assert list(mesh.faces) == ["plate.bottom", "hole.wall", "plate.top"]
    assert mesh.faces["plate.bottom"].facets.tolist() == [[0, 2, 1], [1, 2, 4]]
    assert mesh.faces["plate.top"].nodes.tolist() == [0, 1, 3]
    assert mesh.features["rib"].tets.tolist() == [1]
    assert mesh.features["plate"].nodes.tolist() == [0, 1, 2, 3, 4]
    assert mesh.parent_nodes.tolist() == [-1] * 5 and mesh.sizes is None
    assert mesh.mids.shape == (0, 3) and mesh.all_points is mesh.points
    assert dict(mesh.groups) == {}


def test_names_that_are_not_there_are_told_with_those_that_are():
    mesh = rc.Mesh(assemble(two_tets().messages()))
    with pytest.raises(KeyError, match="no face 'top' .*plate.bottom, hole.wall, plate.top"):
        mesh.faces["top"]
    with pytest.raises(ValueError, match="first order"):
        mesh.tets10


def test_groups_of_the_model_are_sets_of_facets_and_tets():
    sent = two_tets()
    sent.add(pb.MESH_ARRAY_GROUP_NAMES, "load\ncore\nlost\n")
    sent.add(pb.MESH_ARRAY_GROUP_FACETS, [[0, 0], [0, 2]])
    sent.add(pb.MESH_ARRAY_GROUP_TETS, [[1, 1]])
    groups = rc.Mesh(assemble(sent.messages())).groups
    assert list(groups) == ["load", "core", "lost"]
    assert groups["load"].facets.tolist() == [[0, 2, 1], [1, 2, 4]]
    assert groups["load"].nodes.tolist() == [0, 1, 2, 4]
    assert groups["core"].tets.tolist() == [1] and groups["core"].nodes.tolist() == [1, 2, 3, 4]
    assert len(groups["lost"].nodes) == 0


def test_groups_with_members_that_are_not_there_are_refused():
    for member in ([0, 3], [1, 0], [-1, 0], [0, -1]):
        sent = two_tets().add(pb.MESH_ARRAY_GROUP_NAMES, "load\n")
        sent.add(pb.MESH_ARRAY_GROUP_FACETS, [member])
        with pytest.raises(rc.MeshDamaged, match="GROUP_FACETS has an index out of range"):
            assemble(sent.messages())


def test_arrays_are_read_only_since_the_next_mesh_is_made_of_them():
    mesh = rc.Mesh(assemble(two_tets().messages()))
    for array in (mesh.points, mesh.tets, mesh.faces["hole.wall"].nodes):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


def test_parts_of_any_size_give_the_same_mesh():
    whole = assemble(two_tets().messages())
    pieces = assemble(two_tets(part_bytes=7).messages())
    for array, values in whole.numbers.items():
        assert np.array_equal(values, pieces.numbers[array])
    assert whole.texts == pieces.texts


def test_an_array_of_a_newer_protocol_is_passed_over():
    sent = two_tets()
    sent.header.arrays.add(array=99, type=pb.ARRAY_TYPE_U8, components=1, count=2, bytes=2,
                           encoding=pb.MeshHeader.ENCODING_WHOLE, data_bytes=2)
    sent.data.append((99, b"ab"))
    assert rc.Mesh(assemble(sent.messages())).tets.shape == (2, 4)


FAULTS = {
    "a second header": lambda m: m.insert(1, m[0]),
    "a part comes before the header": lambda m: m.pop(0),
    "NODES has a gap": lambda m: setattr(m[1].part, "offset", 3),
    "wrong CRC-32C in part 2 of NODE_IDS": lambda m: setattr(m[3].part, "crc32c", 7),
    "TETS is not complete": lambda m: m.pop(2),
    "parts are missing": lambda m: setattr(m[-1].end, "parts", 3),
    "its end is missing": lambda m: m.pop(),
    "something follows its end": lambda m: m.append(m[-1]),
    "an empty message": lambda m: m.insert(2, pb.MeshMessage()),
    "TETS has the wrong count": lambda m: setattr(m[0].header, "tets", 3),
    "NODES is of another type": lambda m: setattr(m[0].header.arrays[0], "components", 2),
    "wrong digest of TETS": lambda m: setattr(m[0].header.arrays[1], "digest", "0" * 64),
    "TETS is announced twice": lambda m: m[0].header.arrays.append(m[0].header.arrays[1]),
    "NODE_IDS is missing": lambda m: m[0].header.arrays.pop(2),
    "FACET_GROUPS has the wrong count": lambda m: setattr(m[0].header.arrays[7], "count", 3),
}


@pytest.mark.parametrize("what", FAULTS)
def test_a_fault_is_told_by_name(what):
    messages = two_tets().messages()
    FAULTS[what](messages)
    with pytest.raises(rc.MeshDamaged, match=what) as told:
        assemble(messages)
    assert told.value.reason == "MESH_DAMAGED" and told.value.code == "DATA_LOSS"


@pytest.mark.parametrize("array, values", [
    (pb.MESH_ARRAY_TETS, [[0, 1, 2, 5], [1, 2, 3, 4]]),
    (pb.MESH_ARRAY_TETS, [[0, 1, 2, -1], [1, 2, 3, 4]]),
    (pb.MESH_ARRAY_FACET_TETS, [0, 0, 2]),
    (pb.MESH_ARRAY_FACET_GROUP, [0, 2, 0]),
    (pb.MESH_ARRAY_TET_CELLS, [0, 2]),
    (pb.MESH_ARRAY_NODE_TRANSFORMS, [0, -1, -1, -1, -1]),
    (pb.MESH_ARRAY_NODE_ORIGINS, [3, 0, 0, 0, 0])])
def test_an_index_out_of_range_is_refused(array, values):
    good = two_tets()
    sent = MeshMessages(nodes=5, tets=2, facets=3)
    for entry, (name, data) in zip(good.header.arrays, good.data):
        text = KNOWN[name].is_text
        same = data.decode() if text else np.frombuffer(data, KNOWN[name].dtype)
        sent.add(name, values if name == array else same)
    with pytest.raises(rc.MeshDamaged, match="index out of range"):
        assemble(sent.messages())


def test_a_facet_must_be_one_of_its_tet():
    sent = two_tets()
    sent.header.arrays[5].digest = digest(np.array([0, 0, 0], "<i4").tobytes())
    sent.data[5] = (pb.MESH_ARRAY_FACET_TETS, np.array([0, 0, 0], "<i4").tobytes())
    with pytest.raises(rc.MeshDamaged, match="a facet is not one of its tet"):
        assemble(sent.messages())


BASE = np.arange(40, dtype="<i4").reshape(10, 4)


@pytest.mark.parametrize("shape", [(F64, 3), (I32, 4), (I32, 2), (U8, 1), (U64, 1), (F64, 12)])
def test_deltas_of_copied_shifted_and_own_rows(shape):
    dtype, components = shape
    base = (np.arange(30 * components) % 251).astype(dtype).reshape(30, components)
    own = (np.arange(4 * components) % 7 + 100).astype(dtype).reshape(4, components)
    made = apply_delta(delta((COPY, 10, 0), (ROWS, 3, 0), (COPY, 5, 7), (REPEAT, 6, 0),
                             (COPY, 2, -24), rows=own.tobytes()),
                       kind(dtype, components), 26, base if components > 1 else base.ravel())
    expected = np.concatenate([base[:10], own[:3], base[20:25], own[[3] * 6], base[:2]])
    assert np.array_equal(made.array.reshape(-1, components), expected)
    assert made.changed.tolist() == [[10, 13], [13, 18], [18, 24], [24, 26]]


@pytest.mark.parametrize("dtype, start, first", [(I32, -3, -3), (U8, 250, 250), (I32, 2**31 - 3,
                                                                                2**31 - 3),
                                                 (U64, -1, 2**64 - 1), (U64, 5, 5)])
def test_deltas_that_count(dtype, start, first):
    count = 1 if first == 2**64 - 1 else 3
    made = apply_delta(delta((COUNT, count, start)), kind(dtype), count, np.empty(0, dtype))
    assert made.array.tolist() == list(range(first, first + count))


BAD = {
    "lists of a delta differ": (pb.ArrayDelta(kinds=[COPY], counts=[10]), 10),
    "wrong number of rows": (delta((COPY, 9, 0)), 10),
    "empty run": (delta((COPY, 10, 0), (COPY, 0, 0)), 10),
    "kind that is not known": (delta((7, 10, 0)), 10),
    "run of rows has a start": (delta((ROWS, 10, 1), rows=bytes(160)), 10),
    "copies rows that are not there": (delta((COPY, 10, 1)), 10),
    "lacks rows": (delta((ROWS, 10, 0), rows=bytes(159)), 10),
    "some that no run uses": (delta((COPY, 10, 0), rows=bytes(16)), 10),
    "counts where there are no single": (delta((COUNT, 10, 0)), 10),
}


@pytest.mark.parametrize("what", BAD)
def test_a_wrong_delta_is_refused(what):
    message, count = BAD[what]
    with pytest.raises(rc.MeshDamaged, match=what):
        apply_delta(message, kind(I32, 4), count, BASE)


@pytest.mark.parametrize("dtype, start", [(U8, 254), (U8, -1), (I32, 2**31 - 2), (U64, -2),
                                          (I32, -2**63), (I32, 2**63 - 1)])
def test_a_delta_that_counts_too_far_is_refused(dtype, start):
    with pytest.raises(rc.MeshDamaged, match="counts too far"):
        apply_delta(delta((COUNT, 3, start)), kind(dtype), 3, np.empty(0, dtype))


def test_huge_starts_are_refused_and_do_not_wrap():
    for start in (2**63 - 1, -2**63, 2**62):
        with pytest.raises(rc.MeshDamaged, match="not there"):
            apply_delta(delta((COPY, 10, start)), kind(I32, 4), 10, BASE)


def test_digests_of_random_deltas_are_those_of_all_bytes():
    random = np.random.default_rng(1)
    for components in (1, 3):
        base = random.random((20000, components)).reshape(-1, components)
        base = base if components > 1 else base.ravel()
        digests = _checksum.block_digests(base)
        for count in (20000, 19000, 21000, 5, 0):
            runs, own, at = [], [], 0
            while at < count:
                size = int(min(random.integers(1, 3000), count - at))
                if at + size <= len(base) and random.random() < .8:
                    runs.append((COPY, size, 0))
                else:
                    runs.append((ROWS, size, 0))
                    own.append(random.random((size, components)))
                at += size
            rows = b"".join(part.tobytes() for part in own)
            made = apply_delta(delta(*runs, rows=rows), kind(F64, components), count, base)
            blocks = _checksum.changed_digests(made.array, base.nbytes, digests, made.changed,
                                               8 * components)
            assert blocks == _checksum.block_digests(made.array)
            assert _checksum.digest(blocks) == digest(made.array.tobytes())


def test_a_mesh_comes_as_the_difference_to_its_base():
    base = assemble(two_tets().messages())
    sent = two_tets(revision="rev-2", base="rev-1")
    moved = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [2, 2, 2]], "<f8")
    rows = delta((COPY, 4, 0), (ROWS, 1, 0), rows=moved[4:].tobytes())
    for k, (name, data) in enumerate(sent.data):
        sent.header.arrays[k].encoding = pb.MeshHeader.ENCODING_SAME
        sent.header.arrays[k].data_bytes = 0
        sent.data[k] = (name, b"")
    sent.header.arrays[0].encoding = pb.MeshHeader.ENCODING_DELTA
    sent.header.arrays[0].digest = digest(moved.tobytes())
    sent.data[0] = (pb.MESH_ARRAY_NODES, rows.SerializeToString())
    sent.header.arrays[0].data_bytes = len(sent.data[0][1])
    mesh = assemble(sent.messages(), base)
    assert np.array_equal(mesh.numbers[pb.MESH_ARRAY_NODES], moved)
    assert mesh.numbers[pb.MESH_ARRAY_TETS] is base.numbers[pb.MESH_ARRAY_TETS]
    with pytest.raises(rc.MeshDamaged, match="revision 'rev-1', which is not here"):
        assemble(sent.messages())


def test_checksums_of_both_libraries_agree():
    for size in (0, 1, 7, 4096, 100001):
        data = bytes(k * 37 % 256 for k in range(size))
        assert _checksum.crc32c(data) == crc32c(data)
