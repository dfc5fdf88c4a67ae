"""The rules of the source tree that a compiler does not check.

Each rule takes the tree's root and yields violations as `path:line: what is wrong`.
"""
import os
import re
from pathlib import Path

# The road the data travels.
STATIONS = ("libm base mesh kernel model delaunay cellular local_fuse difference sizing plan "
            "boundary nodes optimise extract improve verify revision patch delivery second_order "
            "motion remesh").split()
# What programs under any licence may be built from (deploy/LICENSING.md).
APACHE_FOLDERS = ("proto", "client/library", "client/include", "client/formats", "client/python",
                  "client/report")
APACHE_MARK = "SPDX-License-Identifier: Apache-2.0"
APACHE_SOURCES = {".cpp", ".h", ".proto", ".py", ".cmake", ".yaml", ".txt", ".js", ".css"}
# Each sees those after it, and engine.
SERVER_LAYERS = "process config transport service guard session admission tier designs store observe".split()
# Of the client, the layer `service` may have the writers of mesh files and what fills a mesh.
MESH_FILE_HEADERS = {"client/library/mesh_arrays.h", "remeshd/mesh.h", "remeshd/mesh_file.h"}

INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')
GEOMETRY_KERNEL = re.compile(r"CGAL/|tetgen\.h$|.*\.[hl]xx$")  # OpenCASCADE's headers end in xx
PROTOCOL = re.compile(r"google/protobuf/|grpcpp/|grpc/|.*\.pb\.h$")
# Spelled so that this file does not break its own rule.
MACHINE_PATH = re.compile(r"(?<![\w.$})-])/(?:%s)/" % "|".join(("work", "root", "Users")))
HOME_PATH = re.compile(r"(?<![\w.$})-])/%s/" % "home")
TEXT = {".cpp", ".h", ".txt", ".cmake", ".json", ".md", ".py", ".sh", ".proto", ".in", ".service",
        ".yaml", ".yml", ".toml", ".tsv", ""}


def files(root, folder=".", suffixes=None):
    """Files below root/folder in sorted order, as paths relative to root; build output left out."""
    for where, folders, names in os.walk(Path(root) / folder):
        folders[:] = sorted(f for f in folders if not f.startswith(("build", ".git", ".cache"))
                            and f != "__pycache__")
        for name in sorted(set(names) - {".git"}):  # a file in a linked work tree
            path = Path(where) / name
            if suffixes is None or path.suffix in suffixes:
                yield path.relative_to(root)


def lines(root, path):
    try:
        return enumerate((Path(root) / path).read_text(encoding="utf-8").splitlines(), 1)
    except UnicodeDecodeError:
        return enumerate(())


def includes(root, folder):
    """(path, line, system, header) for every include of the C++ files below root/folder."""
    for path in files(root, folder, {".cpp", ".h"}):
        for number, line in lines(root, path):
            if m := INCLUDE.match(line):
                yield path, number, m[1] == "<", m[2]


def stations_include_only_earlier_ones(root):
    for path, number, system, header in includes(root, "engine"):
        station = path.parts[1]
        if len(path.parts) < 3 or station not in STATIONS:
            yield f"{path}: lies in no station of the engine"
        elif header.startswith("engine/"):
            other = header.split("/")[1]
            if other not in STATIONS or STATIONS.index(other) > STATIONS.index(station):
                yield f"{path}:{number}: {station} comes before {other} and may not include it"
        elif header.startswith(("server/", "client/", "proto/", "remesh/", "remeshd/", "tests/")):
            yield f"{path}:{number}: the engine includes {header}"
        elif not system:
            yield f"{path}:{number}: {header} is not a full path"


TYPE = re.compile(r"^(?:class|struct|enum class|enum|union) (\w+)\b(?!::)(?=[^;]*\{)", re.M)
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{", re.M)


def a_type_has_one_home(root):
    """Two types of one name in one namespace are one to the linker, whatever the headers say."""
    homes = {}
    for path in files(root, ".", {".h"}):
        if path.parts[0] not in ("engine", "server", "client", "proto"):
            continue
        text = (Path(root) / path).read_text(encoding="utf-8")
        namespace = NAMESPACE.search(text)
        for m in TYPE.finditer(text):
            home = homes.setdefault((namespace[1] if namespace else "", m[1]), path)
            if home != path:
                line = text.count("\n", 0, m.start()) + 1
                yield f"{path}:{line}: {m[1]} is a type of {home} too"


MOST_LINES = 400  # of a source of the engine
MOST_FILES = 25  # of a folder of the engine, headers and sources


def engine_rooms_are_small(root):
    folders = {}
    for path in files(root, "engine", {".h", ".cpp"}):
        folders.setdefault(path.parent, []).append(path)
        count = sum(1 for _ in lines(root, path))
        if count > MOST_LINES:
            yield f"{path}: has {count} lines, more than {MOST_LINES}"
    for folder, found in folders.items():
        if len(found) > MOST_FILES:
            yield f"{folder}: has {len(found)} files, more than {MOST_FILES}"


def geometry_kernels_stay_in_kernel(root):
    for folder in ("engine", "server", "client", "tests"):
        for path, number, _, header in includes(root, folder):
            allowed = path.parts[:2] == ("engine", "kernel") and path.suffix == ".cpp"
            allowed |= path.parts[0] == "tests" and header.startswith("CGAL/")
            if GEOMETRY_KERNEL.match(header) and not allowed:
                yield f"{path}:{number}: {header} belongs in engine/kernel/*.cpp"


def protocol_stays_in_service(root):
    for path, number, _, header in includes(root, "engine"):
        if PROTOCOL.match(header):
            yield f"{path}:{number}: the engine includes {header}"
    for path, number, _, header in includes(root, "server"):
        layer = path.parts[1]
        inner = layer in ("session", "admission", "store")
        transport = layer == "transport" and not header.startswith(("grpcpp/", "grpc/"))
        if PROTOCOL.match(header) and (inner or transport):
            yield f"{path}:{number}: {header} belongs in server/service"


def server_layers_look_inwards(root):
    for path, number, _, header in includes(root, "server"):
        of_files = path.parts[1] == "service" and header in MESH_FILE_HEADERS
        if header.startswith(("client/", "remeshd/", "tests/")) and not of_files:
            yield f"{path}:{number}: the server includes {header}"
        layer, other = path.parts[1], (header.split("/") + [""])[1]
        if header.startswith("server/") and layer in SERVER_LAYERS and other in SERVER_LAYERS:
            if SERVER_LAYERS.index(other) < SERVER_LAYERS.index(layer):
                yield f"{path}:{number}: {layer} may not include {other}, which lies outside it"


def apache_folders_say_so(root):
    """Every source there names its licence in its first line (in the second after `#!`)."""
    for folder in APACHE_FOLDERS:
        for path in files(root, folder, APACHE_SOURCES):
            head = [line for _, line in lines(root, path)][:2]
            if head and head[0].startswith("#!"):
                head = head[1:]
            if not head or APACHE_MARK not in head[0]:
                yield f"{path}:1: lacks the line `{APACHE_MARK}`"


def apache_folders_include_nothing_else_of_ours(root):
    """Else a program that is built from them would come under the AGPL."""
    for folder in APACHE_FOLDERS:
        for path, number, _, header in includes(root, folder):
            ours = header.startswith(("engine/", "server/", "client/", "tests/"))
            if ours and not header.startswith(tuple(f + "/" for f in APACHE_FOLDERS)):
                yield f"{path}:{number}: {folder} is Apache-2.0 and may not include {header}"


def no_path_of_one_machine(root):
    for path in files(root):
        if path.suffix in TEXT:
            for number, line in lines(root, path):
                made_up = path.name.endswith("_test.cpp")  # tests of path rules make up homes
                if m := MACHINE_PATH.search(line) or (not made_up and HOME_PATH.search(line)):
                    yield f"{path}:{number}: names {m[0]}, a path of one machine"


RULES = [stations_include_only_earlier_ones, a_type_has_one_home, engine_rooms_are_small,
         geometry_kernels_stay_in_kernel,
         protocol_stays_in_service, server_layers_look_inwards, apache_folders_say_so,
         apache_folders_include_nothing_else_of_ours, no_path_of_one_machine]
