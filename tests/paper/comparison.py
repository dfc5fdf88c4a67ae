"""One comparison of Sect. 9: mesh the original, remesh by the edit, then mesh the modified model
from scratch with the node count that the remesh came out with."""
from dataclasses import dataclass

import numpy as np

import mesh_check
from cases import Case


@dataclass
class Comparison:
    case: Case
    nodes: int       # asked of the original
    iterations: int
    seed: int
    original: dict   # Reports
    remesh: dict
    regular: dict
    faults: list     # sentences; of the remesh and of the regular mesh

    @property
    def ratio(self):
        """% time of Table 3."""
        return 100 * self.remesh["seconds"]["total"] / self.regular["seconds"]["total"]

    def record(self):
        """All of it as JSON takes it."""
        return {"case": self.case.name} | {k: v for k, v in vars(self).items() if k != "case"}

    def count_error(self):
        """By how much the regular runs miss the node counts asked for, relative."""
        return max(abs(self.original["nodes"] / self.nodes - 1),
                   abs(self.regular["nodes"] / self.remesh["nodes"] - 1))

    def quality_gap(self, when):
        """How far the remesh's cumulative histogram of volume-length lies above (is worse than)
        the regular run's where it does most; `when` is `quality_before` (the clean-up) or `quality`."""
        bins = [(r if when in r else r["diagnostics"])[when]["histogram"]
                for r in (self.remesh, self.regular)]
        share = [np.cumsum(b) / sum(b) for b in bins]
        return float((share[0] - share[1]).max())


def compare(daemon, case, nodes, iterations, seed):
    # The paper starts from random nodes (Sects. 3.2 and 7); an edit inherits that.
    options = ["--iterations", iterations, "--seed", seed, "--start", "random"]
    original = daemon.run("mesh", case.path(case.original), "--nodes", nodes, *options, out="original")
    remesh = daemon.run("edit", original["revision"], case.path(case.edit), out="remesh")
    regular = daemon.run("mesh", case.path(case.modified), "--nodes", remesh["nodes"], *options, out="regular")
    if original["cached"] or remesh["cached"] or regular["cached"]:
        raise RuntimeError("a Report came from the cache: its seconds are not of this run")

    parent, edited, scratch = (mesh_check.Mesh(daemon.file(name + ".vtu"))
                               for name in ("original", "remesh", "regular"))
    faults = []
    for name, mesh, report in (("remesh", edited, remesh), ("regular", scratch, regular)):
        faults += [f"{name}: {fault}" for fault in
                   mesh_check.faults(mesh, case.path(case.modified), case.exact_volume)]
        if abs(report["exact_volume"] / case.exact_volume - 1) > 1e-6:
            faults.append(f"{name}: exact volume reported as {report['exact_volume']}")
    counted = mesh_check.kept(edited, parent)
    if counted != (remesh["nodes_kept"], remesh["tets_kept"]):
        faults.append(f"remesh: {counted} nodes and tets are kept, the Report says "
                      f"{(remesh['nodes_kept'], remesh['tets_kept'])}")
    return Comparison(case, nodes, iterations, seed, original, remesh, regular, faults)
