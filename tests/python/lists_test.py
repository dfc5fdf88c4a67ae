"""Lists of addresses, by the synchronous client and the one for asyncio."""
import asyncio
import hashlib
import os
import subprocess
import time
from pathlib import Path

import grpc
import pytest

import remesh_client as rc
from fake_daemons import ENDS, Error, FakeDaemon, error
from remesh_client import aio
from remesh_client._connection import Access
from remesh_client._farm import Farm
from remesh_client._search import AWAY, Search

REMESH = Path(os.environ.get("REMESH_TEST_BUILD", ".")) / "bin/remesh"
MODEL = {"name": "bracket", "features": []}
CUT = (grpc.StatusCode.INTERNAL, "Received RST_STREAM with error code 2")
NONE_LEFT = (grpc.StatusCode.UNAVAILABLE, "no replica is available", (("server", "nginx"),))
STARTING = error(Error.CODE_UNAVAILABLE, Error.STARTING, retry_after=.4)


class Waited:
    """What has calls to be awaited, as if they had not."""

    def __init__(self, thing, loop):
        self.thing, self._loop = thing, loop

    def __getattr__(self, name):
        value = getattr(self.thing, name)
        if not asyncio.iscoroutinefunction(value):
            return value

        def call(*arguments, **named):
            made = self._loop.run_until_complete(value(*arguments, **named))
            return Waited(made, self._loop) if isinstance(made, aio.Part) else made
        return call


@pytest.fixture(params=["threads", "asyncio"])
def connect(request):
    loop, made = asyncio.new_event_loop(), []

    def connect(*arguments, **named):
        if request.param == "threads":
            made.append(rc.connect(*arguments, **named))
        else:
            async def connected():
                return aio.connect(*arguments, **named)
            made.append(Waited(loop.run_until_complete(connected()), loop))
        return made[-1]
    yield connect
    for daemon in made:
        daemon.close()
    loop.close()


def ranked(addresses, route):
    return sorted(addresses, reverse=True, key=lambda address: hashlib.sha256(
        f"{address}\n{route}".encode()).digest())


@pytest.fixture
def farm():
    """Three daemons, in rank for the loops of `bracket`."""
    daemons = {daemon.address: daemon for daemon in (FakeDaemon() for _ in range(3))}
    yield [daemons[address] for address in ranked(daemons, "bracket")]
    for daemon in daemons.values():
        daemon.stop()


def addresses(farm):
    return sorted(daemon.address for daemon in farm)


def asked(farm):
    return [daemon.asked for daemon in farm]


def test_a_route_has_one_rank_in_all_clients():
    """The C++ client's test has the same lines."""
    farm = Farm(["a:1", "b:2", "unix:/c"], Access(), 0)
    firsts = {route: Search(farm, route).replica().address for route in (
        "bracket", "valve", "", "r", 64 * "0")}
    farm.close()
    assert firsts == {"bracket": "a:1", "valve": "b:2", "": "a:1", "r": "unix:/c", 64 * "0": "b:2"}


def test_all_requests_of_a_loop_go_to_one_daemon_with_the_key_of_its_route(connect, farm, tmp_path):
    daemon = connect(addresses(farm))
    part = daemon.mesh(MODEL, with_mesh=False)
    part.edit(radius=5, mesh=False)
    part.write(tmp_path / "a.inp")
    assert (tmp_path / "a.inp").read_bytes() == farm[0].file
    daemon.open("bracket@3").edit(radius=6, mesh=False)
    assert asked(farm) == [5, 0, 0]
    assert set(farm[0].keys) == {hashlib.sha256(b"bracket").hexdigest()[:16]}


@pytest.mark.skipif(not REMESH.exists(), reason="remesh is not built")
def test_the_command_line_asks_the_same_daemon_with_the_same_key(farm):
    with rc.connect(addresses(farm)) as daemon:
        daemon.mesh(MODEL, with_mesh=False)
    for words in (["edit", "bracket@3", "--set", "radius=5", "-o", "-", "--format", "vtu"],
                  ["explain", "bracket"]):
        subprocess.run([REMESH, *words, "--address", ",".join(addresses(farm))], check=False,
                       capture_output=True)
    assert asked(farm) == [3, 0, 0] and len(set(farm[0].keys)) == 1


def test_the_key_is_sent_to_one_daemon_alone_too(connect, farm):
    connect(farm[1].address).mesh(MODEL, design="valve", with_mesh=False)
    assert farm[1].keys == [hashlib.sha256(b"valve").hexdigest()[:16]]


def test_a_first_mesh_in_no_design_has_a_route_of_its_own_and_its_loop_keeps_it(connect, farm):
    for seed in range(1, 17):
        connect(addresses(farm)).mesh(MODEL, file=False, seed=seed, with_mesh=False).edit(
            radius=5, file=False, mesh=False)
    keys = [daemon.keys for daemon in farm]
    assert all(one == other for each in keys for one, other in zip(each[::2], each[1::2]))
    assert len(set(sum(keys, []))) == 16 and sum(bool(each) for each in keys) > 1


@pytest.mark.parametrize("failure", [CUT, NONE_LEFT])
def test_what_a_balancer_says_is_an_answer_though_no_daemon_gave_one_yet(connect, farm, failure):
    farm[0].failures = [failure, None, failure]
    daemon = connect(farm[0].address)
    daemon.mesh(MODEL, with_mesh=False)
    connect(farm[0].address).open("bracket")
    assert asked(farm) == [4, 0, 0]


@pytest.mark.parametrize("failure", [
    CUT, (grpc.StatusCode.UNAVAILABLE, "gone"), (grpc.StatusCode.CANCELLED, "ending"),
    (grpc.StatusCode.UNKNOWN, "Stream removed"),
    (grpc.StatusCode.UNKNOWN, "Received http2 header with status: 500"), STARTING])
def test_where_one_does_not_answer_the_next_in_rank_does(connect, farm, tmp_path, failure):
    daemon = connect(addresses(farm))
    part = daemon.mesh(MODEL, with_mesh=False)
    farm[0].always = failure
    part = part.edit(radius=5, mesh=False)
    part.write(tmp_path / "a.inp")
    assert (tmp_path / "a.inp").read_bytes() == farm[0].file
    assert farm[1].asked == 2 and farm[2].asked == 0


def test_a_stream_that_ends_without_an_answer_goes_on(connect, farm):
    farm[0].failures = [ENDS]
    connect(farm[0].address).mesh(MODEL, with_mesh=False)
    assert asked(farm) == [2, 0, 0]


def test_what_the_daemon_itself_finds_wrong_is_an_error(connect, farm):
    farm[0].failures = [(grpc.StatusCode.INTERNAL, "a fault of the daemon"),
                        error(Error.CODE_INTERNAL, Error.INTERNAL)]
    daemon = connect(addresses(farm))
    for _ in range(2):
        with pytest.raises(rc.RemeshError):
            daemon.mesh(MODEL, with_mesh=False)
    assert asked(farm) == [2, 0, 0]


def test_one_that_was_away_is_asked_again_after_a_while(connect, farm):
    daemon = connect(addresses(farm))
    part = daemon.mesh(MODEL, with_mesh=False)
    farm[0].failures = [CUT]
    for expected in ([2, 1, 0], [2, 2, 0]):
        part.edit(radius=5, mesh=False)
        assert asked(farm) == expected
    time.sleep(AWAY + .1)
    part.edit(radius=5, mesh=False)
    assert asked(farm) == [3, 2, 0]


def test_what_one_does_not_know_the_others_are_asked(connect, farm):
    unknown = error(Error.CODE_NOT_FOUND, Error.REVISION_NOT_FOUND)
    farm[0].always = farm[1].always = unknown
    daemon = connect(addresses(farm))
    daemon.open("bracket").edit(radius=5, mesh=False)
    assert asked(farm) == [2, 2, 2]
    farm[2].always = unknown
    with pytest.raises(rc.NotFound):
        daemon.open("bracket")
    assert asked(farm) == [3, 3, 3]


def test_a_design_is_asked_for_where_it_lives(connect, farm):
    farm[0].always = error(Error.CODE_FAILED_PRECONDITION, Error.DESIGN_ELSEWHERE,
                           home=farm[2].address)
    daemon = connect(addresses(farm))
    part = daemon.mesh(MODEL, with_mesh=False)
    assert asked(farm) == [1, 0, 1]
    part.edit(radius=5, mesh=False)
    daemon.open("bracket")
    assert asked(farm) == [1, 0, 3], "its home is remembered"


def test_the_home_of_a_design_is_waited_for(connect, farm):
    farm[0].always = error(Error.CODE_FAILED_PRECONDITION, Error.DESIGN_ELSEWHERE,
                           home=farm[2].address)
    farm[2].failures = [STARTING]
    connect(addresses(farm)).mesh(MODEL, with_mesh=False)
    assert asked(farm) == [1, 0, 2]


def test_a_home_that_is_not_in_the_list_is_told(connect, farm):
    farm[0].always = error(Error.CODE_FAILED_PRECONDITION, Error.DESIGN_ELSEWHERE,
                           home="10.0.0.9:50051")
    with pytest.raises(rc.MeshingFailed, match="10.0.0.9:50051") as told:
        connect(addresses(farm)).mesh(MODEL, with_mesh=False)
    assert told.value.home == "10.0.0.9:50051" and told.value.reason == "DESIGN_ELSEWHERE"
    assert asked(farm) == [1, 0, 0]
    with pytest.raises(rc.MeshingFailed, match="10.0.0.9:50051"):
        connect(farm[0].address).open("bracket")


def test_two_that_name_each_other_as_home_are_asked_once(connect, farm):
    for one, other in ((0, 1), (1, 0)):
        farm[one].always = error(Error.CODE_FAILED_PRECONDITION, Error.DESIGN_ELSEWHERE,
                                 home=farm[other].address)
    with pytest.raises(rc.MeshingFailed):
        connect(addresses(farm)).open("bracket")
    assert asked(farm) == [1, 1, 0]


def test_patience_bounds_it_all(connect, farm):
    daemon = connect(addresses(farm), patience=1.5)
    part = daemon.mesh(MODEL, with_mesh=False)
    for each in farm:
        each.always = CUT
    begun = time.monotonic()
    with pytest.raises(rc.RemeshError, match="RST_STREAM"):
        part.edit(radius=5, mesh=False)
    assert .9 < time.monotonic() - begun < 3
    assert asked(farm) == [3, 2, 2]


def test_a_timeout_bounds_the_waiting_too(connect, farm):
    daemon = connect(addresses(farm))
    part = daemon.mesh(MODEL, with_mesh=False)
    for each in farm:
        each.always = error(Error.CODE_UNAVAILABLE, Error.STARTING, retry_after=20)
    begun = time.monotonic()
    with pytest.raises(rc.Unavailable):
        part.edit(radius=5, mesh=False, timeout=1)
    assert time.monotonic() - begun < 2


def test_patience_begins_with_the_first_failure(farm):
    search = Search(Farm(addresses(farm), Access(), .5), "bracket")
    time.sleep(.6)  # of computing
    broken = rc.errors.from_error(STARTING)
    for count in range(3):
        wait = search.delay(search.replica(), broken, True)
        assert wait == 0 if count < 2 else .3 < wait <= .4
    time.sleep(wait)
    assert search.delay(search.replica(), broken, True) == 0


def test_none_that_ever_answered_is_waited_for(connect):
    begun = time.monotonic()
    with pytest.raises(rc.Unavailable):
        connect("127.0.0.1:1,127.0.0.1:2").info()
    assert time.monotonic() - begun < 5


@pytest.mark.parametrize("wrong, message", [
    ("a:1,local", "one of several"), ("local,a:1", "one of several"), ([], "no address"),
    (" , ", "no address")])
def test_lists_that_make_no_sense_are_refused(connect, wrong, message):
    with pytest.raises(ValueError, match=message):
        connect(wrong)


def test_an_address_that_stands_twice_is_one(connect, farm):
    daemon = connect([farm[0].address, f" {farm[0].address}"])
    assert daemon.address == farm[0].address
