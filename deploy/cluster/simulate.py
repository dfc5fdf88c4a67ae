#!/usr/bin/python3
"""What a cluster of replicas does under load: who is busy, who waits, what the tier gets.

    deploy/cluster/simulate.py --replicas 100 [--zipf 1.0] [--mtbf 10] [--json]

Discrete events (python3-simpy3), by the service times of service_times.json. The same options and
seed give the same figures. 1,000 replicas take three minutes; for more: placement.py.
"""
import argparse
import dataclasses
import json
import statistics

from service_times import MeasuredTimes
from settings import Settings
from simulation import Simulation

HELP = {
    "cores": "of a replica; as many workers",
    "edits_per_hour": "asked for; default: 40,000 a replica",
    "replicas": "of remeshd", "seed": "of all chance",
    "designs": "that loops begin with; default: 1,000 a replica",
    "zipf": "exponent of their popularity",
    "routing": "design | loop | spread | bounded: what a loop's replica is chosen by",
    "routes": "of a design, for spread", "bound": "of the mean number of loops, for bounded",
    "edits_of_loop": "least and most", "least_think": "s between edits, at least",
    "think": "s between edits, mean", "cache": "MiB of revisions in memory (--cache of remeshd)",
    "queue": "edits that may wait (--queue of remeshd)", "preparers": "reads of bases at a time",
    "acknowledge": "tier | local", "tier_requests": "a second", "tier_bandwidth": "MB/s",
    "tier_latency": "s", "pack_every": "edits, of which the tier gets one's mesh, whole",
    "writers": "packs at a time that a replica writes to the tier",
    "mtbf": "h between failures of a replica; 0: none", "down": "s until it is back",
    "disk_lost": "share of failures that take the store along",
    "detect": "s until a client knows that a request was cut off",
    "zone_at": "s after the warm-up when one of the zones fails; 0: never", "zones": "in all",
    "heads": "share of edits that move a head", "heads_a_second": "compare-and-sets, at most",
    "warm_up": "s not counted", "seconds": "s counted"}


def quantile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else 0.0


def worst_of(course):
    """Of a run in which a zone fails: p99 before, at worst and at the end; the tier's most MB/s."""
    p99 = [quantile(latencies, .99) for _, latencies, _ in course]
    width = course[1][0] - course[0][0]
    return {"p99_before_s": p99[0], "p99_worst_s": max(p99), "p99_end_s": p99[-1],
            "tier_MB_a_second_most": max(megabytes for _, _, megabytes in course) / width}


def figures(simulation):
    """What a simulation counted, by name."""
    settings, seconds = simulation.settings, simulation.settings.seconds
    room = settings.cores * seconds
    used = sorted(replica.busy / room for replica in simulation.replicas)
    held = sorted(replica.held / room for replica in simulation.replicas)
    edits, hits = len(simulation.waits), simulation.hits
    tier = simulation.tier
    found = {
        "loops": len(simulation.loops), "edits": edits,
        "edits_per_hour": 3600 * edits / seconds, "asked_per_hour": 3600 * settings.rate(),
        "cores_busiest": used[-1], "cores_median": statistics.median(used),
        "workers_busiest": held[-1], "workers_median": statistics.median(held),
        "replicas_above_95": sum(each > .95 for each in held),
        "wait_mean_s": statistics.fmean(simulation.waits) if edits else 0.0,
        "wait_p50_s": quantile(simulation.waits, .5), "wait_p99_s": quantile(simulation.waits, .99),
        "edit_mean_s": statistics.fmean(simulation.latencies) if edits else 0.0,
        "edit_p50_s": quantile(simulation.latencies, .5),
        "edit_p99_s": quantile(simulation.latencies, .99),
        "tier_requests_a_second": tier.requests.amount / seconds,
        "tier_MB_a_second": tier.megabytes.amount / seconds,
        "tier_wait_p99_s": quantile(tier.waits, .99),
        "packs_waiting_most": max(len(r.outbox.items) for r in simulation.replicas),
        "memory_hits": hits["memory"] / max(1, sum(hits.values())),
        "store_hits": hits["store"] / max(1, sum(hits.values())),
        "tier_hits": hits["tier"] / max(1, sum(hits.values())),
        "failures": simulation.failures, "edits_cut_off": simulation.broken,
        "edits_recomputed": simulation.remade, "edits_refused": simulation.refused,
        "waits_for_home": simulation.stalled, "edits_lost": simulation.lost}
    return found | (worst_of(simulation.course) if settings.zone_at else {})


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for field in dataclasses.fields(Settings):
        option = "--" + field.name.replace("_", "-")
        if field.name == "edits_of_loop":
            parser.add_argument(option, type=int, nargs=2, default=field.default,
                                help=HELP[field.name])
        else:
            parser.add_argument(option, type=field.type, default=field.default,
                                help=HELP[field.name])
    parser.add_argument("--json", action="store_true", help="instead of a table")
    return parser.parse_args()


def main():
    told = vars(arguments())
    as_json = told.pop("json")
    found = figures(Simulation(Settings(**told), MeasuredTimes()))
    if as_json:
        print(json.dumps({"settings": told, "figures": found}, indent=1))
        return
    for name, value in found.items():
        print(f"{name:24s} {value:14,.4g}" if isinstance(value, float) else
              f"{name:24s} {value:14,d}")


if __name__ == "__main__":
    main()
