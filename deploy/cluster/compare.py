#!/usr/bin/python3
"""Compares the simulator with a real daemon: five clients, one worker, on two cores.

    deploy/cluster/compare.py

The rest of the daemon and the clients had the second core, so that the worker took an edit's
seconds in the engine, or little more; where all cores have workers, a core takes all of the
daemon's seconds for it, as simulate.py has it.
"""
from service_times import MeasuredTimes
from settings import Settings
from simulate import quantile
from simulation import Simulation


def main():
    measured = MeasuredTimes().told["several_clients"]
    print(f"{'':28s} {'edits/s':>8s} {'mean s':>8s} {'p50':>8s} {'p90':>8s} {'p99':>8s}")
    names = ("edits_a_second", "mean_s", "p50_s", "p90_s", "p99_s")
    print(f"{'measured':28s}", *(f"{measured[name]:8.3f}" for name in names))
    for label, of_engine in (("simulated, engine's seconds", True),
                             ("simulated, all of a core", False)):
        times = MeasuredTimes(of_engine=of_engine)
        rate = measured["loops"] / (measured["think_s"] + times.edit_s)
        found = Simulation(Settings(
            replicas=1, cores=1, edits_per_hour=3600 * rate, think=measured["think_s"],
            least_think=0, seconds=3000), times)
        taken = found.latencies
        print(f"{label:28s}", *(f"{each:8.3f}" for each in (
            len(taken) / 3000, sum(taken) / len(taken),
            *(quantile(taken, share) for share in (.5, .9, .99)))))


if __name__ == "__main__":
    main()
