"""Names of the protocol that stand in the sources as texts: reasons of errors, codes of warnings.

The engine and the session do not see protobuf, so no compiler compares the two.
"""
import re
from pathlib import Path

from structure import files, lines

PROTO = Path("proto/remesh/v1")
SOURCES = ("engine", "server", "proto", "client")
# Reasons that no source gives by name.
NOT_GIVEN = {
    "REASON_UNSPECIFIED",
    "DEADLINE_PASSED",                # gRPC's
    "UNSUPPORTED",                    # of a daemon that does not have all of the protocol
    "TOO_MANY_STREAMS", "STARTING",   # load
    "NOT_ALLOWED",                    # access
    "STREAM_ENDED", "MESH_DAMAGED",   # told by clients
}
# Texts of that form that are no names of the protocol.
OTHERS = re.compile(r"(REMESH|REMESHD|XDG|NOTIFY)_|RST_STREAM$")  # environment; HTTP/2

ENUMERATOR = re.compile(r"^\s*([A-Z][A-Z0-9_]*) = \d+;")
TEXT = re.compile(r'"([A-Z][A-Z0-9]*(?:_[A-Z0-9]+)*)"')
COMMENT = re.compile(r"//.*")


def enumerators(root, within=None):
    """Names of all enumerators of the protocol, or of those of one enum of error.proto."""
    names = set()
    for path in files(root, PROTO, {".proto"}):
        if within and path.name != "error.proto":
            continue
        inside = within is None
        for _, line in lines(root, path):
            if within and line.strip().startswith("enum "):
                inside = line.split()[1] == within
            if inside and (found := ENUMERATOR.match(line)):
                names.add(found[1])
    return names


def texts(root):
    """(path, line, name) for each text in the sources that looks like an enumerator."""
    for folder in SOURCES:
        for path in files(root, folder, {".cpp", ".h"}):
            for number, line in lines(root, path):
                for found in TEXT.finditer(COMMENT.sub("", line)):
                    yield path, number, found[1]


def texts_like_enumerators_are_enumerators(root):
    """Or the names of gRPC's codes, which error.proto has with a prefix."""
    known = enumerators(root)
    known |= {name.removeprefix("CODE_") for name in known}
    for path, number, name in texts(root):
        if "_" in name and name not in known and not OTHERS.match(name):
            yield f"{path}:{number}: {name} is no name of the protocol"


def reasons_are_given(root):
    """Each by some source, and just those that are listed by none."""
    given = {name for _, _, name in texts(root)}
    for name in sorted(enumerators(root, within="Reason") - given - NOT_GIVEN):
        yield f"{PROTO / 'error.proto'}:1: no source gives the reason {name}"
    for path, number, name in texts(root):
        if name in NOT_GIVEN:
            yield f"{path}:{number}: {name} is listed as given by no source"


RULES = [texts_like_enumerators_are_enumerators, reasons_are_given]
