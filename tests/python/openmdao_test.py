"""The component for OpenMDAO, by a stand-in of its interface where it is not installed (Debian has
it not): names, arguments and the order of calls are those of OpenMDAO 3."""
import importlib
import sys
import types

import numpy as np
import pytest

import remesh_client as rc
from fake_daemons import Error, error
from remesh_client.errors import from_error


class Options(dict):
    def declare(self, name, default=None, values=None, **_):
        self.setdefault(name, default)


class ExplicitComponent:
    """What RemeshComponent uses of it."""

    def __init__(self, **options):
        self.options, self.inputs, self.outputs, self.partials = Options(), {}, {}, []
        self.initialize()
        unknown = set(options) - set(self.options)
        assert not unknown, unknown
        self.options.update(options)

    def add_input(self, name, val=1.0, units=None):
        self.inputs[name] = (np.atleast_1d(val), units)

    def add_output(self, name, val=1.0):
        self.outputs[name] = np.atleast_1d(val)

    def declare_partials(self, of, wrt, method="exact", form=None, step=None, step_calc=None):
        self.partials.append((of, wrt, method, form, step, step_calc))


class AnalysisError(Exception):
    pass


@pytest.fixture
def component(monkeypatch):
    """The class, over the stand-in."""
    api = types.ModuleType("openmdao.api")
    api.ExplicitComponent, api.AnalysisError = ExplicitComponent, AnalysisError
    package = types.ModuleType("openmdao")
    package.api = api
    monkeypatch.setitem(sys.modules, "openmdao", package)
    monkeypatch.setitem(sys.modules, "openmdao.api", api)
    monkeypatch.delitem(sys.modules, "remesh_client.openmdao", raising=False)
    yield importlib.import_module("remesh_client.openmdao").RemeshComponent
    sys.modules.pop("remesh_client.openmdao", None)


def made(component, daemon, cases, **changes):
    options = {"daemon": daemon, "model": cases / "tool1-a.json", "mesh_options": {"nodes": 800},
               "parameters": ["pin_radius"], "outputs": {"volume": 1.0, "centre": np.zeros(3)},
               "evaluate": lambda part: {"volume": part.report.volume,
                                         "centre": part.mesh().points.mean(axis=0)}, **changes}
    one = component(**options)
    one.setup()
    one.setup_partials()
    return one


def test_parameters_are_inputs_and_results_outputs(component, daemon, cases):
    part = made(component, daemon, cases, parameters={"pin_radius": "mm"})
    value, units = part.inputs["pin_radius"]
    assert (value.tolist(), units) == ([4.0], "mm")
    assert part.partials == [("*", "*", "fd", "central", 1e-3, "rel")]
    volumes = []
    for radius in (4.5, 5.5, 4.5):
        outputs = {}
        part.compute({"pin_radius": np.array([radius])}, outputs)
        assert outputs["centre"].shape == (3,)
        volumes.append(outputs["volume"])
    assert volumes[0] != volumes[1]
    assert volumes[0] == volumes[2]  # the same inputs, the same outputs


def test_what_cannot_be_meshed_is_an_analysis_error(component, daemon, cases):
    model = {"parameters": {"gap": -1}, "features": [
        {"id": "left", "nature": "ADDITIVE", "type": "block",
         "parameters": {"dx": 10, "dy": 10, "dz": 10}},
        {"id": "right", "nature": "ADDITIVE", "type": "block",
         "parameters": {"dx": 10, "dy": 10, "dz": 10}, "placement": {"origin": ["10 + gap", 0, 0]}}]}
    part = made(component, daemon, cases, model=model, parameters=["gap"])
    with pytest.raises(AnalysisError):
        part.compute({"gap": np.array([5.0])}, {})
    outputs = {}
    part.compute({"gap": np.array([-2.0])}, outputs)
    assert outputs["volume"] == pytest.approx(1800)


@pytest.mark.parametrize("code, reason", [
    (Error.CODE_INVALID_ARGUMENT, Error.DEGENERATE_FEATURE),
    (Error.CODE_INVALID_ARGUMENT, Error.MESH_TOO_LARGE),
    (Error.CODE_OUT_OF_RANGE, Error.REASON_UNSPECIFIED),
    (Error.CODE_FAILED_PRECONDITION, Error.BOUNDARY_NOT_RECOVERED)])
def test_a_step_into_values_that_are_refused_is_an_analysis_error(component, code, reason):
    with pytest.raises(AnalysisError, match="told by the test"):
        refused(component, code, reason)


def test_what_no_other_step_would_mend_is_the_daemons_error(component):
    with pytest.raises(rc.Unavailable):
        refused(component, Error.CODE_UNAVAILABLE, Error.SHUTTING_DOWN)


def refused(component, code, reason):
    """Computes with a daemon that refuses each edit."""
    class Part:
        def document(self):
            return {"parameters": {"width": 4}}

        def edit(self, values):
            raise from_error(error(code, reason))

    class Daemon:
        def mesh(self, model, **options):
            return Part()
    part = component(daemon=Daemon(), model={}, parameters=["width"], outputs={})
    part.setup()
    part.compute({"width": np.array([-1.0])}, {})


def test_features_parameters_are_inputs_too(component, daemon, cases):
    model = {"features": [{"id": "a", "nature": "ADDITIVE", "type": "block",
                           "parameters": {"dx": 10, "dy": 4, "dz": 3}}]}
    part = made(component, daemon, cases, model=model, parameters=["a.dx"])
    outputs = {}
    part.compute({"a:dx": np.array([12.0])}, outputs)
    assert outputs["volume"] == pytest.approx(144)


def test_faults_of_the_caller_are_told(component, daemon, cases):
    with pytest.raises(KeyError, match="no parameter 'pin_radus'"):
        made(component, daemon, cases, parameters=["pin_radus"])
    part = made(component, daemon, cases, evaluate=lambda part: {"volume": 1})
    with pytest.raises(KeyError, match="gives no centre"):
        part.compute({"pin_radius": np.array([4.0])}, {})
