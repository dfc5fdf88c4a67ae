"""Which replica a loop goes to, and which designs are asked for how often."""
import bisect
import itertools

import numpy as np

RANKS = 16  # of a route that are kept; where all are down the loop waits


def zipf_shares(designs, exponent):
    """Shares of all loops, the most popular design first."""
    weights = np.arange(1, designs + 1, dtype=float) ** -exponent
    return weights / weights.sum()


class Popularity:
    """Draws designs by their shares."""

    def __init__(self, designs, exponent):
        self._sums = list(itertools.accumulate(zipf_shares(designs, exponent)))

    def draw(self, chance):
        return min(bisect.bisect(self._sums, chance.random()), len(self._sums) - 1)


def _mixed(values):
    """splitmix64's finalizer: stands for the client's SHA-256, and is quick on arrays."""
    values = (values ^ (values >> np.uint64(30))) * np.uint64(0xbf58476d1ce4e5b9)
    values = (values ^ (values >> np.uint64(27))) * np.uint64(0x94d049bb133111eb)
    return values ^ (values >> np.uint64(31))


class Rendezvous:
    """The first replicas in rank for a route (an integer), by rendezvous hashing."""

    def __init__(self, replicas):
        with np.errstate(over="ignore"):
            self._seeds = _mixed(np.arange(1, replicas + 1, dtype=np.uint64)
                                 * np.uint64(0x9e3779b97f4a7c15))
        self._known = {}

    def ranks(self, route):
        found = self._known.get(route)
        if found is None:
            with np.errstate(over="ignore"):
                scores = _mixed(self._seeds ^ _mixed(np.array([route + 1], dtype=np.uint64)))
            count = min(RANKS, len(scores))
            best = np.argpartition(scores, len(scores) - count)[len(scores) - count:]
            found = tuple(int(each) for each in best[np.argsort(scores[best])[::-1]])
            self._known[route] = found
        return found
