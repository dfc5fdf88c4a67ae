"""Fixtures: one daemon for the tests of a file, and the documents of tests/cases."""
import os
from pathlib import Path

import pytest

import remesh_client as rc

CASES = Path(__file__).parent.parent / "cases"
REMESHD = os.environ.get("REMESH_TEST_PROGRAM", "remeshd")


@pytest.fixture(scope="session")
def remeshd():
    """The path of the program."""
    return REMESHD


@pytest.fixture(scope="session")
def daemon():
    with rc.local(REMESHD) as started:
        yield started


@pytest.fixture(scope="session")
def cases():
    return CASES


@pytest.fixture(scope="session")
def tool(daemon):
    """A first mesh of some 1,000 nodes of the model that the paper edits most."""
    return daemon.mesh(CASES / "tool1-a.json", nodes=1000)
