"""The client for asyncio."""
import asyncio
import threading
import time

import pytest

import remesh_client as rc
from remesh_client import aio
from remesh_client._assembler import assemble
from remesh_client.v1 import report_pb2, revision_pb2
from fake_daemons import FakeDaemon
from synthetic import two_tets


def run(remeshd, scenario):
    async def main():
        async with aio.local(remeshd) as daemon:
            await scenario(daemon)
    asyncio.run(main())


def test_edits_meshes_and_files(remeshd, cases, tmp_path):
    async def scenario(daemon):
        part = await daemon.mesh(cases / "tool1-a.json", nodes=1000)
        await part.mesh()
        edits = await asyncio.gather(*(part.edit(pin_radius=r) for r in (4.5, 5, 5.5)))
        for edited, mesh in zip(edits, await asyncio.gather(*(e.mesh() for e in edits))):
            assert len(mesh.points) == edited.report.nodes and edited.report.nodes_kept > 0
            whole = await daemon._fetch(edited.revision)
            for array, values in whole.numbers.items():
                assert values.tobytes() == mesh.content.numbers[array].tobytes()
        path = await edits[0].write(tmp_path / "a.inp")
        assert path.stat().st_size > 10000
        with pytest.raises(RuntimeError, match="await part.write"):
            mesh.write(tmp_path / "b.inp")
        again = await daemon.open(edits[0].revision)
        assert len((await again.mesh()).points) == edits[0].report.nodes
    run(remeshd, scenario)


def test_a_mesh_has_the_exact_areas_of_its_report():
    class Daemon:
        async def _fetch(self, revision, route):
            return assemble(two_tets().messages())
    report = report_pb2.Report(groups=[{"group": "load", "exact_area": 6.5}, {"group": "core"}])
    part = aio.Part(Daemon(), revision_pb2.RevisionInfo(id="rev-1"), report)
    assert asyncio.run(part.mesh()).exact_areas == {"load": 6.5}


def test_an_edit_goes_to_the_design_of_its_part_and_to_no_other(remeshd, cases):
    async def scenario(daemon):
        model = cases / "tool1-a.json"
        loose = await daemon.mesh(model, nodes=500, file=False)
        for name in ("anna", "bert"):
            part = await daemon.mesh(model, nodes=500, design=name)
        assert (await part.edit(pin_radius=5)).design == "bert"
        assert (await loose.edit(pin_radius=5)).design == ""
        async with aio.connect(daemon.address) as other:
            part = await other.open(loose.revision)
            assert part.design == ""
            with pytest.raises(rc.InvalidRequest, match="design"):
                await part.edit(pin_radius=5)
    run(remeshd, scenario)


def test_errors_and_progress(remeshd, cases):
    async def scenario(daemon):
        told = []
        part = await daemon.mesh(cases / "tool1-a.json", nodes=1000, progress=told.append)
        assert told
        with pytest.raises(rc.InvalidRequest) as error:
            await part.edit(pin_radus=5)
        assert error.value.reason == "UNKNOWN_PARAMETER"

        def enough(progress):
            raise LookupError("enough")
        with pytest.raises(LookupError, match="enough"):
            await daemon.mesh(cases / "tool1-a.json", nodes=60000, progress=enough)
        assert (await part.edit(pin_radius=5)).report.nodes > 0
    run(remeshd, scenario)


async def idle(daemon):
    for _ in range(600):
        if (await daemon.info()).load.running == 0:
            return
        await asyncio.sleep(.05)
    raise AssertionError("the daemon goes on computing")


def test_cancelling_a_task_cancels_its_computation_alone(remeshd, cases):
    async def scenario(daemon):
        part = await daemon.mesh(cases / "tool1-a.json", nodes=1000)
        long = asyncio.create_task(daemon.mesh(cases / "tool1-a.json", nodes=300000))
        waiting = asyncio.create_task(part.edit(pin_radius=5))
        await asyncio.sleep(.3)
        long.cancel()
        with pytest.raises(asyncio.CancelledError):
            await long
        assert len((await (await waiting).mesh()).points) > 0
        await idle(daemon)
        with pytest.raises(rc.DeadlineExceeded):
            await daemon.mesh(cases / "tool1-a.json", nodes=300000, timeout=.3)
        await idle(daemon)
    run(remeshd, scenario)


def test_a_daemon_that_is_not_there(cases):
    async def main():
        async with aio.connect("127.0.0.1:1") as daemon:
            with pytest.raises(rc.Unavailable):
                await daemon.mesh(cases / "tool1-a.json")
            with pytest.raises(rc.Unavailable):
                await daemon.info()
    asyncio.run(main())


class DaemonThatDoesNotRead(FakeDaemon):
    """It reads no request until it is told to: what is larger than the window of the connection is
    still being written."""

    def __init__(self):
        super().__init__()
        self.reads = threading.Event()

    def EditStream(self, requests, context):
        self.reads.wait(30)
        yield from super().EditStream(requests, context)


@pytest.fixture
def unread():
    daemon = DaemonThatDoesNotRead()
    yield daemon
    daemon.reads.set()
    daemon.stop()


LARGE, SMALL = {"name": "n" * 3_000_000}, {"name": "n"}


def test_a_task_that_is_cancelled_while_its_request_is_written_leaves_the_others_alone(unread):
    async def main():
        async with aio.connect(unread.address) as daemon:
            one, other = (asyncio.create_task(daemon.mesh(LARGE)) for _ in range(2))
            await asyncio.sleep(.5)
            one.cancel()
            with pytest.raises(asyncio.CancelledError):
                await one
            late = asyncio.create_task(daemon.mesh(SMALL))
            await asyncio.sleep(.1)
            unread.reads.set()
            assert (await asyncio.wait_for(other, 20)).revision
            assert (await asyncio.wait_for(late, 20)).revision
            assert (await asyncio.wait_for(daemon.mesh(SMALL), 20)).revision
    asyncio.run(main())
