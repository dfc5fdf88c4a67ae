"""The client against a daemon."""
import json
import os
import pickle
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import remesh_client as rc
from remesh_client._arrays import KNOWN
from remesh_client.options import mesh_options


def same(one, other):
    """All arrays of two meshes, to the bit."""
    a, b = one.content, other.content
    assert a.texts == b.texts and a.numbers.keys() == b.numbers.keys()
    for array, values in a.numbers.items():
        assert values.tobytes() == b.numbers[array].tobytes(), KNOWN[array]
    return True


@pytest.mark.parametrize("order", [1, 2])
def test_the_loop_of_an_optimiser(daemon, cases, tmp_path, order):
    part = daemon.mesh(cases / "tool1-a.json", nodes=1500, order=order, seed=2)
    for radius in (4.5, 5, 5.25):
        before, part = part, part.edit(pin_radius=radius)
        mesh = part.mesh()
        report = part.report
        assert (len(mesh.points), len(mesh.tets), mesh.order) == (report.nodes, report.tets, order)
        assert report.nodes_kept > 0.5 * report.nodes
        kept = mesh.origins == 1
        assert np.count_nonzero(kept) == report.nodes_kept
        whole = rc.Mesh(daemon._fetch(part.revision))  # by GetMesh, without a delta
        assert same(mesh, whole)
        identity = kept & (mesh.node_transforms == 0) & (mesh.transforms[0] == np.eye(3, 4).ravel()
                                                         ).all()
        assert np.array_equal(mesh.points[identity], before.mesh().points[mesh.parent_nodes[identity]])
        path = mesh.write(tmp_path / f"{radius}.inp")
        assert path.stat().st_size > 10000


def test_edits_are_given_in_every_form(daemon, tool, tmp_path):
    by_name = tool.edit(pin_radius=5)
    document = {"edits": [{"setParameter": {"name": "pin_radius", "value": 5}}]}
    (tmp_path / "edit.json").write_text(json.dumps(document))
    forms = [{"pin_radius": 5}, {"pin_radius": np.float64(5)}, rc.set_parameter("pin_radius", 5),
             document, document["edits"][0], [{"pin_radius": 5}], tmp_path / "edit.json",
             str(tmp_path / "edit.json")]
    for form in forms:
        assert tool.edit(form).revision == by_name.revision, form
    feature = tool.document()["features"][-1]["id"]
    assert feature not in [f["id"] for f in tool.edit(rc.remove(feature)).document()["features"]]
    moved = tool.edit({"pin1.radius": 5}, rc.set_parameter("pin2.radius", "pin_radius + 1"))
    parameters = {f["id"]: f["parameters"] for f in moved.document()["features"]}
    assert parameters["pin1"]["radius"] == 5 and parameters["pin2"]["radius"] == "pin_radius + 1"


def test_messages_of_the_protocol_are_taken_too(daemon, tool):
    from remesh_client.v1 import document_pb2, revision_pb2
    reply = daemon._ask("GetRevision", revision_pb2.GetRevisionRequest(revision=tool.revision))
    assert daemon.mesh(reply.model, nodes=1000).revision == tool.revision
    assert daemon.validate(reply.model, nodes=1000).volume > 0
    edit = document_pb2.ModelEdit()
    edit.edits.add().set_parameter.name = "pin_radius"
    edit.edits[0].set_parameter.value.number_value = 5
    assert tool.edit(edit).revision == tool.edit(pin_radius=5).revision


def test_a_mesh_goes_to_another_process(tool):
    copy = pickle.loads(pickle.dumps(tool.mesh()))
    assert same(copy, tool.mesh()) and copy.faces["pin1.wall"].nodes.size
    with pytest.raises(RuntimeError, match="no daemon at hand"):
        copy.write("a.inp")


def test_two_edits_of_one_part_and_a_mesh_that_nobody_read(daemon, tool):
    first, second = tool.edit(pin_radius=4.75), tool.edit(pin_radius=5.5)
    child = first.edit(pin_radius=5)  # against a mesh that is still on its way
    assert same(child.mesh(), rc.Mesh(daemon._fetch(child.revision)))
    assert same(second.mesh(), rc.Mesh(daemon._fetch(second.revision)))
    assert first.mesh() is first.mesh()


def test_a_mesh_comes_later_where_it_was_not_asked_for(daemon, tool):
    part = tool.edit(pin_radius=6, mesh=False)
    assert len(part.mesh().points) == part.report.nodes
    again = daemon.open(part.revision[:10])
    assert again.revision == part.revision and same(again.mesh(), part.mesh())
    assert [info.id for info in daemon.log(tool.design)].count(part.revision) == 1


def test_a_damaged_delta_is_fetched_whole(daemon, tool, monkeypatch):
    from remesh_client import _assembler
    part = tool.edit(pin_radius=6.25)
    monkeypatch.setattr(_assembler._checksum, "digest", lambda blocks: "0")
    part._exchange.carrier.wait(part._exchange, lambda exchange: exchange.done)
    monkeypatch.undo()
    assert part._exchange.mesh_error.reason == "MESH_DAMAGED"
    assert len(part.mesh().points) == part.report.nodes


def test_second_order_has_its_nodes_in_the_order_of_vtk(daemon, cases):
    mesh = daemon.mesh(cases / "tool1-a.json", nodes=500, order=2).mesh()
    corners, ten = mesh.tets, mesh.tets10
    assert mesh.all_points.shape == (len(mesh.points) + len(mesh.mids), 3)
    assert np.array_equal(ten[:, :4], corners) and ten.max() == len(mesh.all_points) - 1
    for column, (a, b) in enumerate([(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]):
        edges = np.sort(mesh.edge_mids[mesh.tet_mids[:, column]], axis=1)
        assert np.array_equal(edges, np.sort(corners[:, [a, b]], axis=1))
    face = mesh.faces["pin1.wall"]
    assert set(face.facets.ravel()) < set(face.all_nodes) and face.facets6.shape[1] == 6


def test_files_are_those_of_the_daemons_writers(daemon, tool, tmp_path, remeshd):
    mesh = tool.mesh()
    for ending in ("vtu", "msh", "inp"):
        assert mesh.write(tmp_path / f"a.{ending}") == tmp_path / f"a.{ending}"
        assert tool.write(str(tmp_path / f"b.{ending}")).read_bytes() == (
            tmp_path / f"a.{ending}").read_bytes()
    assert sorted(p.name for p in tmp_path.iterdir()) == [f"{n}.{e}" for n in "ab"
                                                          for e in ("inp", "msh", "vtu")]
    text = (tmp_path / "a.inp").read_text()
    assert f"*NODE" in text and "C3D4" in text and "pin1_wall" in text
    step = tool.write(tmp_path / "model.step").read_text()
    assert mesh.write(tmp_path / "model.stp").read_text() == step
    assert step.startswith("ISO-10303-21;") and "ADVANCED_FACE('pin1.wall'" in step
    assert f"FILE_NAME('{tool.revision}.step'" in step
    with pytest.raises(ValueError, match="endings known are .vtu, .msh, .inp, .step and .stp"):
        mesh.write(tmp_path / "a.stl")
    with pytest.raises(OSError):
        mesh.write(tmp_path / "missing" / "a.inp")


def test_errors_say_what_where_and_what_helps(daemon, tool, tmp_path):
    with pytest.raises(rc.InvalidRequest) as told:
        tool.edit(pin_radus=5)
    assert told.value.reason == "UNKNOWN_PARAMETER" and told.value.code == "INVALID_ARGUMENT"
    assert told.value.edit_index == 0
    with pytest.raises(rc.NotFound) as told:
        tool.edit({"rib.radius": 5})
    assert told.value.reason == "UNKNOWN_FEATURE" and "rib" in told.value.features
    file = tmp_path / "part.json"
    file.write_text('{"name": "part",\n "features": [],\n "colour": 3}')
    with pytest.raises(rc.InvalidRequest, match=r"part.json:3:\d+: ") as told:
        daemon.mesh(file)
    assert (told.value.reason, told.value.line) == ("UNKNOWN_FIELD", 3) and told.value.hint
    copy = pickle.loads(pickle.dumps(told.value))
    assert (str(copy), copy.reason) == (str(told.value), "UNKNOWN_FIELD")
    part = tool.edit(pin_radius=5)  # the stream lives on
    assert part.report.nodes > 0


def test_a_solid_that_cannot_be_meshed_names_features_and_point(daemon):
    box = {"nature": "ADDITIVE", "type": "block", "parameters": {"dx": 10, "dy": 10, "dz": 10}}
    model = {"features": [{"id": "left", **box},
                          {"id": "right", **box, "placement": {"origin": [10, 10, 0]}}]}
    with pytest.raises(rc.MeshingFailed) as told:
        daemon.mesh(model, nodes=200)
    assert told.value.reason in ("NON_MANIFOLD_MODEL", "DISCONNECTED_MODEL")
    assert told.value.features and len(told.value.points) == 1
    assert len(told.value.points[0]) == 3


def test_what_cannot_be_sent_is_told_before_it_is(daemon, tool):
    with pytest.raises(TypeError, match="'node'; is 'nodes' meant"):
        daemon.mesh({"features": []}, node=5)
    with pytest.raises(TypeError, match="nodes or size"):
        daemon.mesh({"features": []}, nodes=5, size=2)
    with pytest.raises(ValueError, match="option order"):
        daemon.mesh({"features": []}, order=-1)
    with pytest.raises(ValueError, match="not JSON compliant"):
        tool.edit(pin_radius=float("nan"))
    with pytest.raises(TypeError, match="cannot stand in a document"):
        tool.edit(pin_radius=object())
    with pytest.raises(ValueError, match="without any change"):
        tool.edit()
    with pytest.raises(TypeError, match="an edit cannot be"):
        tool.edit(5)
    with pytest.raises(FileNotFoundError):
        daemon.mesh("missing.json")
    with pytest.raises(rc.InvalidRequest, match="more than the limit") as told:
        daemon.mesh({"name": "x" * (5 << 20)})
    assert told.value.reason == "DOCUMENT_TOO_LARGE"


def test_options_that_are_none_are_left_out():
    for given in ({"nodes": None, "size": 2}, {"nodes": None, "size": 2, "fail_on": None}):
        assert mesh_options(given) == mesh_options({"size": 2})
    assert mesh_options({"nodes": None, "size": None, "threads": None}) is None


def test_warnings_are_told_and_can_be_errors(daemon, tool):
    lost = tool.edit(rc.remove("pin1"))
    assert "FACE_LOST" in [warning.code for warning in lost.warnings]
    assert str(lost.warnings[0]).startswith(lost.warnings[0].code + ": ")
    with pytest.raises(rc.MeshingFailed) as told:
        tool.edit(rc.remove("pin2"), options={"fail_on": ["FACE_LOST"]})
    assert told.value.reason == "WARNING_IS_ERROR"


def test_progress_is_told_and_what_the_callback_raises_cancels(daemon, cases):
    told = []
    daemon.mesh(cases / "tool1-a.json", nodes=1100, progress=told.append)
    assert told and all(0 <= p.fraction <= 1 for p in told)
    assert "optimise" in [p.stage for p in told]

    def enough(progress):
        raise LookupError("enough")
    with pytest.raises(LookupError, match="enough"):
        daemon.mesh(cases / "tool1-a.json", nodes=60000, progress=enough)
    wait_until_idle(daemon)
    assert daemon.mesh(cases / "tool1-a.json", nodes=1100).report.cached


def wait_until_idle(daemon):
    for _ in range(600):
        if daemon.info().load.running == 0:
            return
        time.sleep(.05)
    raise AssertionError("the daemon goes on computing")


def test_a_timeout_cancels_the_computation_alone(daemon, tool, cases):
    with pytest.raises(rc.DeadlineExceeded, match="time given to the request"):
        daemon.mesh(cases / "tool1-a.json", nodes=200000, timeout=.3)
    wait_until_idle(daemon)
    assert tool.edit(pin_radius=5).mesh().points.shape[1] == 3


def test_ctrl_c_cancels_the_computation_and_leaves_the_daemon_usable(remeshd, cases):
    """Many times over, as the signal may strike anywhere in the client."""
    program = f"""
import os, signal, sys, threading, time, remesh_client as rc
with rc.local({remeshd!r}) as daemon:
    part = daemon.mesh({str(cases / 'tool1-a.json')!r}, nodes=500)
    for count in range(60):
        press = threading.Thread(target=lambda: (at_work.wait(), time.sleep(count * 2e-5),
                                                 os.kill(os.getpid(), signal.SIGINT)))
        at_work = threading.Event()
        try:
            press.start()
            daemon.mesh({str(cases / 'tool1-a.json')!r}, nodes=300000, seed=count + 1,
                        progress=lambda p: at_work.set())
        except KeyboardInterrupt:
            print("interrupted", flush=True)
        while daemon.info().load.running:
            time.sleep(.02)
        assert part.edit(pin_radius=5 + count * .01).mesh().points.shape[1] == 3
"""
    run = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True,
                         timeout=120)
    assert run.stdout.split() == 60 * ["interrupted"] and run.returncode == 0


def test_an_edit_goes_to_the_design_of_its_part_and_to_no_other(daemon, cases):
    model = cases / "tool1-a.json"
    anna, bert = (daemon.mesh(model, nodes=500, design=name) for name in ("anna", "bert"))
    assert anna.revision == bert.revision
    first = bert.edit(pin_radius=5, mesh=False)
    assert (first.design, first.number) == ("bert", 2)
    assert first.edit(pin_radius=5.25, mesh=False).design == "bert"
    assert daemon.open("anna@1").edit(pin_radius=5, mesh=False).design == "anna"
    assert [len(daemon.log(name)) for name in ("anna", "bert")] == [2, 3]


def test_a_part_that_an_id_names_is_in_no_design_rather_than_in_any_of_several(daemon, cases):
    model = cases / "tool1-a.json"
    carl = daemon.mesh(model, nodes=520, design="carl", with_mesh=False)
    assert daemon.open(carl.revision).design == "carl"
    daemon.mesh(model, nodes=520, design="dora", with_mesh=False)
    with rc.connect(daemon.address) as other:  # whose stream has worked on neither
        part = other.open(carl.revision)
        assert (part.design, part.number) == ("", 0)
        with pytest.raises(rc.InvalidRequest) as error:
            part.edit(pin_radius=5)
        assert error.value.reason == "MISSING_FIELD" and error.value.parameter == "design"
        assert "`carl`, `dora`" in error.value.hint
        assert part.edit(pin_radius=5, mesh=False, file=False).design == ""
        assert other.open("dora").edit(pin_radius=5, mesh=False).design == "dora"


def test_what_is_made_of_a_part_in_no_design_is_in_none(daemon, cases):
    loose = daemon.mesh(cases / "tool1-a.json", nodes=530, file=False)
    daemon.mesh(cases / "tool1-a.json", nodes=530, design="emil", with_mesh=False)
    assert loose.edit(pin_radius=5, mesh=False).design == ""
    assert len(daemon.log("emil")) == 1


def test_threads_may_share_a_daemon(daemon, tool):
    radii = [4.6, 4.8, 5.2, 5.4]
    meshes = {}
    threads = [threading.Thread(target=lambda r=r: meshes.update({r: tool.edit(pin_radius=r).mesh()}))
               for r in radii]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for radius in radii:
        assert same(meshes[radius], tool.edit(pin_radius=radius).mesh())


def test_a_stream_goes_on_where_the_daemon_is_started_anew(remeshd, cases, tmp_path):
    store, port_file = tmp_path / "store", tmp_path / "port"

    def start(listen):
        return subprocess.Popen([remeshd, "--listen", listen, "--store", store, "--port-file",
                                 port_file, "--grace", "0"], stderr=subprocess.DEVNULL)
    process = start("127.0.0.1:0")
    try:
        while not port_file.exists():
            time.sleep(.02)
        address = f"127.0.0.1:{port_file.read_text().split()[0].rpartition(':')[2]}"
        with rc.connect(address) as daemon:
            part = daemon.mesh(cases / "tool1-a.json", nodes=1000)
            part.mesh()
            process.kill()
            process.wait()
            process = start(address)
            after = part.edit(pin_radius=5)
            assert same(after.mesh(), rc.Mesh(daemon._fetch(after.revision)))
    finally:
        process.kill()
        process.wait()
