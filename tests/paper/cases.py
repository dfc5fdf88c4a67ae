"""The seven cases, what the paper reports for them and what is asked of ours."""
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[1] / "cases"


@dataclass(frozen=True)
class Case:
    name: str
    original: str        # model documents
    edit: str
    modified: str
    exact_volume: float  # mm^3, of the modified model
    nodes_kept: float    # share to be kept at 15,000 nodes and 10 iterations
    paper: dict          # (nodes, iterations): % time of Table 3; empty for our own case

    def path(self, document):
        return str(FOLDER / document)


def _case(name, modified, volume, kept, *percent):
    model = name.split("-")[0]
    original = f"{model}-{name.split('-')[1][0]}"
    rows = zip(((15000, 5), (15000, 10), (30000, 5), (30000, 10)), percent)
    return Case(name, original + ".json", name + ".edit.json", modified + ".json", volume, kept, dict(rows))


CASES = [
    _case("simple-ab", "simple-b", 258000, .75, 10.62, 10.02, 7.51, 7.18),
    _case("tool1-ab", "tool1-b", 113295.255866, .75, 19.25, 12.18, 11.56, 8.38),
    _case("tool1-ac", "tool1-c", 109525.344682, .62, 23.02, 17.98, 15.95, 13.30),
    _case("tool2-ab", "tool2-b", 172863.715790, .75, 39.54, 29.48, 31.95, 23.11),
    _case("tool2-bc", "tool2-c", 172863.715790, .80, 42.77, 31.75, 29.93, 21.37),
    _case("tool2-cd", "tool2-d", 172779.646351, .75),
    _case("tool3-ab", "tool3-b", 173327.875959, .15, 43.26, 43.80, 30.55, 27.59),
]
