#!/usr/bin/python3
"""Draws what happens after a third of the replicas fails: zone.png.

    deploy/cluster/plot_zone.py [-o zone.png]      # python3-matplotlib; a minute
"""
import argparse

import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  pylint: disable=wrong-import-position

from service_times import MeasuredTimes  # noqa: E402  pylint: disable=wrong-import-position
from settings import Settings  # noqa: E402  pylint: disable=wrong-import-position
from simulate import quantile  # noqa: E402  pylint: disable=wrong-import-position
from simulation import BUCKET, Simulation  # noqa: E402  pylint: disable=wrong-import-position

COMMON = {"replicas": 100, "routing": "loop", "zone_at": 10, "seconds": 90, "disk_lost": 0}
RUNS = {  # label: what differs
    "60 % busy, tier 10 Gbit/s": {"down": 600},
    "60 % busy, 100 Gbit/s": {"down": 600, "tier_bandwidth": 12_500},
    "60 % busy, 100 Gbit/s, back after 30 s": {"down": 30, "tier_bandwidth": 12_500},
    "40 % busy, 100 Gbit/s": {"down": 600, "tier_bandwidth": 12_500, "edits_per_hour": 2_600_000}}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", default="zone.png")
    told = parser.parse_args()
    figure, (above, below) = pyplot.subplots(2, 1, sharex=True, figsize=(7, 4.6))
    for label, changed in RUNS.items():
        course = Simulation(Settings(**COMMON | changed), MeasuredTimes()).course
        at = [end - BUCKET / 2 for end, _, _ in course]
        above.plot(at, [quantile(latencies, .99) for _, latencies, _ in course], label=label)
        below.plot(at, [megabytes / BUCKET for _, _, megabytes in course])
    above.set_yscale("log")
    above.set_ylabel("edit, p99 (s)")
    above.legend(fontsize=7, ncol=2, loc="lower center", bbox_to_anchor=(.5, 1))
    below.set_ylabel("tier (MB/s)")
    below.set_xlabel("s; a third of 100 replicas fails at 10 s")
    for axes in (above, below):
        axes.axvline(10, color="grey", linewidth=.8)
        axes.grid(alpha=.3)
    figure.tight_layout()
    figure.savefig(told.output, dpi=90)


if __name__ == "__main__":
    main()
