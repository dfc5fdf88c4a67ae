"""Service times that the simulator draws from: those of service_times.json, or of a formula."""
import json
import statistics
from pathlib import Path

MEASURED = Path(__file__).parent / "service_times.json"
_WHOLE_PACK = 2e6  # bytes from which a pack of 15,000 nodes stands on no other


class MeasuredTimes:
    """Of edits of 15,000 nodes: each draw is one measured edit, its seconds with its pack's bytes.

    Seconds are of a core: those in the engine, times what the whole daemon took of the CPU by them.
    of_engine: those in the engine alone; right where other cores do the rest.
    """

    def __init__(self, path=MEASURED, of_engine=False):
        told = json.loads(Path(path).read_text())
        self._edits = []
        for loop in told["loops"].values():
            seconds, packs = loop["edits"]["engine_s"], loop["edits"]["pack_bytes"]
            scale = 1 if of_engine else loop["cpu_s_an_edit"] * len(seconds) / sum(seconds)
            typical = statistics.median(packs)
            self._edits += [(scale * each, pack if pack < _WHOLE_PACK else typical)
                            for each, pack in zip(seconds, packs)]
        loops = told["loops"].values()
        self.edit_s = statistics.mean(each[0] for each in self._edits)
        self.delta_bytes = statistics.mean(each[1] for each in self._edits)
        self.pack_bytes = statistics.mean(
            pack for loop in loops for pack in loop["edits"]["pack_bytes"])
        self.first_s = statistics.mean(loop["first_cpu_s"] for loop in loops)
        self.first_bytes = statistics.mean(loop["first"]["pack_bytes"] for loop in loops)
        self.recipe_bytes = statistics.mean(
            loop["tier_an_edit"]["PUT recipe"]["bytes"] for loop in loops)
        self.answer_bytes = statistics.mean(
            size for loop in loops for size in loop["edits"]["received_bytes"])
        self.first_answer_bytes = statistics.mean(
            loop["first"]["received_bytes"] for loop in loops)
        held = told["evictions"]["128"]
        self.held_bytes = held["memory_bytes"] / held["held"]
        moves = told["moves"]["from_tier"].values()
        self.read_s, self.read_s_a_pack = _line(
            [(each["packs"], each["open_s"]) for each in moves])
        self.told = told

    def edit(self, chance):
        """(s of a core, bytes of the pack) of one edit."""
        return chance.choice(self._edits)

    def reading(self, packs):
        """s of a core until a revision of so many packs is in memory."""
        return self.read_s + self.read_s_a_pack * packs


class ExponentialTimes:
    """As queueing theory has it; packs are of no size and revisions take no memory."""

    first_s = first_bytes = recipe_bytes = held_bytes = delta_bytes = pack_bytes = 0.0

    def __init__(self, mean):
        self.edit_s = mean

    def edit(self, chance):
        return chance.expovariate(1 / self.edit_s), 0.0

    def reading(self, _):
        return 0.0


class ConstantTimes(ExponentialTimes):
    def edit(self, _):
        return self.edit_s, 0.0


def _line(points):
    """(at 0, slope) of the least squares."""
    mean_x, mean_y = (statistics.mean(each[n] for each in points) for n in (0, 1))
    slope = (sum((x - mean_x) * (y - mean_y) for x, y in points)
             / sum((x - mean_x) ** 2 for x, _ in points))
    return mean_y - slope * mean_x, slope
