#!/usr/bin/python3
"""What simulate.py would tell of clusters that are too large for it, by formulas.

    deploy/cluster/placement.py --replicas 10 100 1000 10000 [--zipf 0.8] [--routing design]

Replicas do not wait for each other, but for the tier, whose load is the sum of theirs. So each is a
queue of its own: its loops are drawn and placed as the simulator does it, with a random home a
route (rendezvous hashing gives each route a home that is random, and independent of the others').
Its edits a second and its mean wait are those of a closed M/G/c queue (Erlang C, Allen-Cunneen).
"""
import argparse
import dataclasses

import numpy as np

from routing import zipf_shares
from service_times import MeasuredTimes
from settings import Settings


def loops_by_replica(settings, loops, chance):
    """How many loops have each replica as home."""
    designs = np.searchsorted(np.cumsum(zipf_shares(settings.designs, settings.zipf)),
                              chance.random(loops)).clip(max=settings.designs - 1)
    if settings.routing == "loop":
        return np.bincount(chance.integers(0, settings.replicas, loops),
                           minlength=settings.replicas)
    if settings.routing == "spread":
        homes = chance.integers(0, settings.replicas, (settings.designs, settings.routes))
        placed = homes[designs, chance.integers(0, settings.routes, loops)]
    else:
        placed = chance.integers(0, settings.replicas, settings.designs)[designs]
    counts = np.bincount(placed, minlength=settings.replicas)
    if settings.routing == "bounded":  # those beyond the bound go where there is room
        most = settings.bound * (loops / settings.replicas + 1)
        beyond = np.maximum(counts - most, 0).sum()
        counts = np.minimum(counts, most)
        counts = counts + beyond * (most - counts) / max(1e-9, (most - counts).sum())
    return counts


def erlang_c(cores, load):
    """Probability that a core has to be waited for, by the load in cores (below `cores`)."""
    blocked = np.ones_like(load)
    for n in range(1, cores + 1):
        blocked = load * blocked / (n + load * blocked)
    busy = load / cores
    return blocked / (1 - busy * (1 - blocked))


class Closed:
    """Replicas with fixed numbers of loops that think between edits."""

    def __init__(self, settings, times, counts):
        self._settings, self._times = settings, times
        draws = [each for each, _ in times._edits]  # pylint: disable=protected-access
        self._spread = (1 + np.var(draws) / np.mean(draws) ** 2) / 2
        low, high = np.zeros(len(counts)), np.full(len(counts), settings.cores / times.edit_s)
        for _ in range(60):  # edits a second, such that loops / rate = think + answer
            self.rate = (low + high) / 2
            full = self.core_seconds() * self.rate >= .9999 * settings.cores
            spent = settings.think + self.core_seconds() + np.where(full, np.inf, self.wait())
            fewer = counts < self.rate * spent
            high, low = np.where(fewer, self.rate, high), np.where(fewer, low, self.rate)
        self.spent = counts / np.maximum(self.rate, 1e-12) - settings.think

    def missed(self):
        """Share of bases that memory has not any more: those that rested for longer than edits of
        others take to fill it."""
        settings = self._settings
        rest = settings.cache * 2 ** 20 / self._times.held_bytes / (2 * np.maximum(self.rate, 1e-9))
        return np.exp(-np.maximum(rest - settings.least_think, 0)
                      / (settings.think - settings.least_think))

    def core_seconds(self):
        packs = 1 + self._times.first_bytes / self._times.delta_bytes  # half of the most
        return self._times.edit_s + self.missed() * self._times.reading(packs)

    def _queue(self):
        cores, seconds = self._settings.cores, self.core_seconds()
        load = np.minimum(self.rate * seconds, .9999 * cores)
        return erlang_c(cores, load), self._spread * seconds / (cores - load)

    def wait(self):
        chance, mean = self._queue()
        return chance * mean

    def wait_quantile(self, share):
        """Of all edits: s such that so many wait less, their waits being exponential."""
        chance, mean = self._queue()
        low, high = 0.0, 1e4
        for _ in range(60):
            middle = (low + high) / 2
            longer = np.average(chance * np.exp(-middle / mean), weights=self.rate)
            low, high = (middle, high) if longer > 1 - share else (low, middle)
        return high

    def utilisation(self):
        return self.rate * self.core_seconds() / self._settings.cores


def figures(settings, times):
    chance = np.random.default_rng(settings.seed)
    loops = round(settings.rate() * (settings.think + times.edit_s))
    closed = Closed(settings, times, loops_by_replica(settings, loops, chance))
    used, rate = closed.utilisation(), closed.rate.sum()
    edits_of_loop = sum(settings.edits_of_loop) / 2
    return {
        "replicas": settings.replicas, "asked_per_hour": 3600 * settings.rate(),
        "edits_per_hour": 3600 * rate, "cores_busiest": used.max(),
        "cores_median": np.median(used), "replicas_above_95": int((used > .95).sum()),
        "edits_there": np.average(used > .95, weights=closed.rate),
        "wait_p99_s": closed.wait_quantile(.99),
        "edit_mean_s": np.average(closed.spent, weights=closed.rate),
        # HEAD and PUT of the pack, HEAD of the look-up, PUT of the recipe; two of a first mesh
        "tier_requests_a_second": rate * (4 + 2 / edits_of_loop),
        "tier_MB_a_second": rate * (times.pack_bytes + times.recipe_bytes
                                    + times.first_bytes / edits_of_loop) / 1e6}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--replicas", type=int, nargs="+", default=[10, 100, 1000, 10000])
    for name in ("cores", "edits_per_hour", "designs", "zipf", "routing", "routes", "bound",
                 "cache", "seed"):
        default = getattr(Settings, name)
        parser.add_argument("--" + name.replace("_", "-"), type=type(default), default=default)
    told = vars(parser.parse_args())
    rows = [figures(dataclasses.replace(Settings(**told | {"replicas": count})), MeasuredTimes())
            for count in told.pop("replicas")]
    for name in rows[0]:
        print(f"{name:24s}", *(f"{row[name]:14,.4g}" if isinstance(row[name], float) else
                               f"{row[name]:14,d}" for row in rows))


if __name__ == "__main__":
    main()
