# SPDX-License-Identifier: Apache-2.0
"""A component for OpenMDAO (3.x, which Debian does not have): parameters in, results out.

    from remesh_client.openmdao import RemeshComponent
    problem.model.add_subsystem("part", RemeshComponent(
        daemon=daemon, model="bracket.json", mesh_options={"nodes": 8000},
        parameters=["hole_radius", "stiffener"], outputs={"mass": 1.0, "stress": 1.0},
        evaluate=lambda part: {"mass": part.report.volume, "stress": peak_stress(part.mesh())}))
"""
from __future__ import annotations

from typing import Any, Callable, Mapping

import openmdao.api as om

import numpy as np

from remesh_client.errors import InvalidRequest, MeshingFailed
from remesh_client.part import Part

Evaluate = Callable[[Part], Mapping[str, Any]]


class RemeshComponent(om.ExplicitComponent):  # type: ignore[misc]
    """Remeshes a model for each set of its inputs and evaluates the part.

    Options:
        daemon: a Daemon of `rc.connect` or `rc.local`.
        model: as Daemon.mesh has it. mesh_options: as rc.Options.
        parameters: names that are inputs, of the model or of features (`rib.width`); a dot becomes
            a colon in the input's name. A mapping gives units: `{"radius": "mm"}`.
        outputs: by name a value of the output's shape.
        evaluate: of a Part, gives the outputs by name.
        reference: `first` (default): every mesh is an edit of the first one, so that the same
            inputs always give the same outputs. `last`: of the one before, which keeps more nodes
            along a path.
        step, form: of the finite differences of all partials; a relative step. Meshes change their
            nodes where parameters do, so a step should be well above the noise of that.

    A set of inputs that cannot be meshed raises om.AnalysisError, from which optimisers step back.
    """

    def initialize(self) -> None:
        """Declares the options."""
        for name in ("daemon", "model", "parameters", "outputs", "evaluate"):
            self.options.declare(name)
        self.options.declare("mesh_options", default={})
        self.options.declare("reference", default="first", values=["first", "last"])
        self.options.declare("step", default=1e-3)
        self.options.declare("form", default="central")

    def setup(self) -> None:
        """Makes the first mesh; its parameters are the inputs' initial values."""
        self._first: Part = self.options["daemon"].mesh(self.options["model"],
                                                        **self.options["mesh_options"])
        self._last = self._first
        document = self._first.document()
        parameters = self.options["parameters"]
        units = parameters if isinstance(parameters, Mapping) else {}
        self._inputs = {name.replace(".", ":"): name for name in parameters}
        for name, parameter in self._inputs.items():
            self.add_input(name, val=_value(document, parameter), units=units.get(parameter))
        for name, value in self.options["outputs"].items():
            self.add_output(name, val=value)

    def setup_partials(self) -> None:
        """By finite differences: the derivatives of what `evaluate` computes are not known here."""
        self.declare_partials("*", "*", method="fd", step=self.options["step"],
                              step_calc="rel", form=self.options["form"])

    def compute(self, inputs: Any, outputs: Any) -> None:
        """Remeshes and evaluates."""
        values = {parameter: float(np.asarray(inputs[name]).item())
                  for name, parameter in self._inputs.items()}
        base = self._first if self.options["reference"] == "first" else self._last
        try:
            part = base.edit(values)
        except (InvalidRequest, MeshingFailed) as why:
            raise om.AnalysisError(str(why)) from why
        self._last = part
        results = self.options["evaluate"](part)
        missing = set(self.options["outputs"]) - set(results)
        if missing:
            raise KeyError(f"evaluate gives no {', '.join(sorted(missing))}")
        for name in self.options["outputs"]:
            outputs[name] = results[name]


def _value(document: Mapping[str, Any], parameter: str) -> float:
    """Raises KeyError where there is none, ValueError where it is no number."""
    feature, dot, name = parameter.rpartition(".")
    owner = document
    if dot:
        owner = next((f for f in document["features"] if f["id"] == feature), {})
    found = owner.get("parameters", {}).get(name)
    if found is None:
        raise KeyError(f"the model has no parameter {parameter!r}")
    value = found["value"] if isinstance(found, Mapping) else found
    if isinstance(value, str):
        raise ValueError(f"the parameter {parameter!r} is the expression {value!r}; an input has "
                         "to be a number")
    return float(value)
