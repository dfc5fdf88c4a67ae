"""Daemons that are started for one process."""
import os
import signal
import subprocess
import sys
import time

import pytest

import remesh_client as rc
from remesh_client.local import find_program


def gone(pid):
    """Whether the process ends within some seconds."""
    for _ in range(400):
        try:
            with open(f"/proc/{pid}/stat", encoding="utf-8") as stat:
                if stat.read().rpartition(")")[2].split()[0] == "Z":
                    return True
        except OSError:
            return True
        time.sleep(.05)
    return False


def children(pid):
    with open(f"/proc/{pid}/task/{pid}/children", encoding="utf-8") as found:
        return [int(child) for child in found.read().split()]


def test_it_ends_with_the_with_statement_and_leaves_nothing(remeshd):
    with rc.local(remeshd) as daemon:
        assert daemon.info().ready
        guard = daemon._local._guard.pid
        [served] = children(guard)
        folder = daemon._local._folder
        assert folder.exists()
    assert gone(served) and not folder.exists()
    daemon.close()  # a second time is fine


def started(remeshd, tail):
    """A process with a daemon of its own: the process, the daemon's pid, the folder."""
    program = f"""
import os, sys, time, remesh_client as rc
daemon = rc.local({remeshd!r})
guard = daemon._local._guard.pid
child = open(f"/proc/{{guard}}/task/{{guard}}/children").read().split()[0]
print(child, guard, daemon._local._folder, flush=True)
{tail}
"""
    process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    served, guard, folder = process.stdout.readline().split()
    return process, int(served), int(guard), folder


@pytest.mark.parametrize("tail, returncode", [("sys.exit(3)", 3), ("os._exit(4)", 4),
                                              ("os.abort()", -signal.SIGABRT)])
def test_it_ends_however_python_ends(remeshd, tail, returncode):
    process, served, _, folder = started(remeshd, tail)
    assert process.wait(60) == returncode
    assert gone(served)
    for _ in range(100):
        if not os.path.exists(folder):
            break
        time.sleep(.05)
    assert not os.path.exists(folder)


def test_it_ends_where_python_or_its_guard_is_killed(remeshd):
    process, served, guard, _ = started(remeshd, "time.sleep(100)")
    process.kill()
    process.wait()
    assert gone(served)
    process, served, guard, _ = started(remeshd, "time.sleep(100)")
    os.kill(guard, signal.SIGKILL)
    assert gone(served)
    process.kill()
    process.wait()


def test_what_hinders_the_start_is_told(tmp_path):
    with pytest.raises(rc.Unavailable, match="no program"):
        rc.local(tmp_path / "remeshd")
    refusing = tmp_path / "remeshd"
    refusing.write_text("#!/bin/sh\necho the disk is on fire >&2\nexit 1\n")
    refusing.chmod(0o755)
    with pytest.raises(rc.Unavailable, match="the disk is on fire"):
        rc.local(refusing)


def test_a_socket_on_which_nobody_listens_yet_is_waited_for(tmp_path, remeshd):
    slow = tmp_path / "slow"
    slow.write_text(f"""#!{sys.executable}
import os, socket, sys, time
bound = socket.socket(socket.AF_UNIX)
bound.bind(sys.argv[sys.argv.index("--listen") + 1].removeprefix("unix:"))
time.sleep(.5)
os.execv({os.path.abspath(remeshd)!r}, sys.argv)
""")
    slow.chmod(0o700)
    with rc.local(slow) as daemon:
        assert daemon.info().ready


def test_an_option_that_is_not_known_is_told(remeshd):
    with pytest.raises(rc.Unavailable, match="did not start.*--wrokers"):
        rc.local(remeshd, "--wrokers", "2")


def test_connect_starts_one_where_the_address_is_local(remeshd, monkeypatch):
    monkeypatch.setenv("PATH", os.path.dirname(remeshd), prepend=os.pathsep)
    monkeypatch.setenv("REMESH_ADDRESS", "local")
    with rc.connect() as daemon:
        assert daemon.address.startswith("unix:") and daemon.info().load.persistent


def test_an_address_comes_from_the_environment_and_else_is_the_daemons(monkeypatch):
    monkeypatch.setenv("REMESH_ADDRESS", "127.0.0.1:1")
    daemon = rc.connect()
    assert daemon.address == "127.0.0.1:1"
    with pytest.raises(rc.Unavailable):
        daemon.info()
    with pytest.raises(rc.Unavailable):
        daemon.mesh({"features": []})
    monkeypatch.delenv("REMESH_ADDRESS")
    assert rc.connect().address == "127.0.0.1:50051"


def test_a_token_does_not_go_in_the_clear_to_another_machine(tmp_path):
    (tmp_path / "token").write_text("the-secret-token\n")
    with pytest.raises(rc.InvalidRequest, match="for anyone to read"):
        rc.connect("example.com:1", token_file=tmp_path / "token")


def test_a_token_is_sent(remeshd, tmp_path, cases):
    (tmp_path / "tokens").write_text("anna the-secret-token-of-anna\n")
    (tmp_path / "tokens").chmod(0o600)
    (tmp_path / "token").write_text("the-secret-token-of-anna\n")
    with rc.local(remeshd, "--token-file", str(tmp_path / "tokens")) as without:
        with pytest.raises(rc.Denied):
            without.mesh(cases / "tool1-a.json", nodes=500)
        with rc.connect(without.address, token_file=tmp_path / "token") as daemon:
            assert daemon.mesh(cases / "tool1-a.json", nodes=500).mesh().write(tmp_path / "a.vtu")


def test_an_installed_package_finds_the_daemon_beside_it(tmp_path, remeshd):
    build = os.environ.get("REMESH_TEST_BUILD")
    if build is None:
        pytest.skip("run by ctest, which tells the build tree")
    subprocess.run(["cmake", "--install", build, "--component", "client_python", "--prefix",
                    tmp_path], check=True, stdout=subprocess.DEVNULL)
    package = tmp_path / "lib/python3/dist-packages"
    assert (package / "remesh_client/py.typed").exists()
    (tmp_path / "bin").mkdir()
    os.symlink(remeshd, tmp_path / "bin/remeshd")
    program = "import remesh_client as rc; print(rc.local().info().protocol, rc.__file__)"
    out = subprocess.run([sys.executable, "-c", program], check=True, text=True,
                         stdout=subprocess.PIPE, env={"PYTHONPATH": str(package)}).stdout
    assert out.split() == ["remesh.v1", str(package / "remesh_client/__init__.py")]


def test_the_program_is_looked_for_on_path(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(rc.Unavailable, match="nor on PATH"):
        find_program()
