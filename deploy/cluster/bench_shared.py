"""What shared parts take for a request: nginx as tier, PostgreSQL, a client's list of replicas."""
import http.client
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from bench_tier import LoggedTier

SIZES = {"recipe": 6_000, "pack": 400_000, "first_mesh": 2_300_000}


def nginx_requests(count=400):
    """CPU s of nginx's worker for a request, and s as its one client saw it; no wait for a disk."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        tier = LoggedTier(Path(folder) / "tier")
        try:
            connection = http.client.HTTPConnection("127.0.0.1", tier.port)

            def ask(method, path, body=None):
                connection.request(method, path, body)
                connection.getresponse().read()

            for kind, size in SIZES.items():
                body = os.urandom(size)
                ask("PUT", f"/{kind}/00/0", body)
                for method in ("PUT", "GET", "HEAD"):
                    before, begun = tier.cpu_seconds(), time.perf_counter()
                    for n in range(count):
                        ask(method, f"/{kind}/00/{n}", body if method == "PUT" else None)
                    found[f"{method} {kind}"] = {
                        "bytes": size, "cpu_s": (tier.cpu_seconds() - before) / count,
                        "wall_s": (time.perf_counter() - begun) / count}
        finally:
            tier.stop()
    return found


SCHEMA = """
CREATE TABLE head (design text PRIMARY KEY, revision text NOT NULL, number integer NOT NULL);
INSERT INTO head SELECT 'design' || n, 'r0', 0 FROM generate_series(1, 100000) n;
"""
# A head moves only where it still is what the writer saw.
COMPARE_AND_SET = """
\\set design random(1, 100000)
SELECT number AS seen FROM head WHERE design = 'design' || :design \\gset
UPDATE head SET revision = 'r' || random(), number = :seen + 1
  WHERE design = 'design' || :design AND number = :seen;
"""


def postgres_compare_and_sets(clients=(1, 8), seconds=8):
    """Compare-and-sets a second of a PostgreSQL as it comes, by its clients at a time; {} where
    there is none. Server, disk and clients share the machine."""
    programs = Path("/usr/lib/postgresql/15/bin")
    if shutil.which("pgbench") is None or not programs.exists():
        return {}
    folder = Path(tempfile.mkdtemp(prefix="remesh-postgres-"))
    as_user = ["setpriv", "--reuid=postgres", "--regid=postgres", "--clear-groups"]
    shutil.chown(folder, "postgres", "postgres")

    def run(*command, text=None):
        return subprocess.run([*as_user, *command], input=text, check=True, capture_output=True,
                              text=True, cwd=folder).stdout

    run(programs / "initdb", "-D", folder / "data")
    server = ["-D", str(folder / "data"), "-w", "-l", str(folder / "log"), "-o",
              f"-k {folder} -c listen_addresses="]
    run(programs / "pg_ctl", "start", *server)
    try:
        run("psql", "-h", folder, "postgres", text=SCHEMA)
        script = folder / "script.sql"
        script.write_text(COMPARE_AND_SET)
        found = {}
        for count in clients:
            told = run("pgbench", "-h", folder, "-n", "-f", script, "-c", str(count), "-j", "1",
                       "-T", str(seconds), "postgres")
            found[str(count)] = {
                "a_second": float(re.search(r"tps = ([\d.]+)", told)[1]),
                "latency_s": float(re.search(r"latency average = ([\d.]+)", told)[1]) / 1e3}
        return found
    finally:
        run(programs / "pg_ctl", "stop", *server[:3], "-m", "immediate")
        shutil.rmtree(folder, ignore_errors=True)


def client_lists(counts=(10, 100, 1000, 10000)):
    """What a client takes that knows so many replicas: to connect, for each request, of memory;
    each in a process of its own."""
    found = {}
    for count in counts:
        told = subprocess.run([sys.executable, "-c", _LIST, str(count)], check=True,
                              capture_output=True, text=True, cwd=Path(__file__).parent).stdout
        found[str(count)] = dict(zip(("connect_s", "rank_s", "resident_bytes"),
                                     map(float, told.split())))
    return found


_LIST = """
import os, sys, time
from remesh_client._connection import Access
from remesh_client._farm import Farm
from remesh_client._search import Search
from bench_tier import resident_bytes
count = int(sys.argv[1])
addresses = [f"10.{n >> 16}.{n >> 8 & 255}.{n & 255}:50051" for n in range(count)]
memory, begun = resident_bytes(os.getpid()), time.perf_counter()
farm = Farm(addresses, Access(), 30)
opened, tries = time.perf_counter() - begun, max(3, 3000 // count)
begun = time.perf_counter()
for n in range(tries):
    Search(farm, f"route{n}").replica()
print(opened, (time.perf_counter() - begun) / tries, resident_bytes(os.getpid()) - memory)
"""


def shared_parts():
    return {"nginx": nginx_requests(), "postgres_compare_and_sets": postgres_compare_and_sets(),
            "client_lists": client_lists()}
