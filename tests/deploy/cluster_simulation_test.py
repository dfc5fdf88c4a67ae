"""Facts about the simulator in deploy/cluster, by theory where there is one."""
import sys
import unittest
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "deploy/cluster"))
from placement import erlang_c, figures as placed  # noqa: E402
from routing import Rendezvous, zipf_shares  # noqa: E402
from service_times import ConstantTimes, ExponentialTimes, MeasuredTimes  # noqa: E402
from settings import Settings  # noqa: E402
from simulate import figures  # noqa: E402
from simulation import Simulation  # noqa: E402

# Many loops that think for long ask as a Poisson process does.
QUEUE = Settings(replicas=1, cores=1, edits_per_hour=.6 * 3600, think=1500, least_think=0,
                 queue=10 ** 6, tier_latency=0, tier_requests=1e12, tier_bandwidth=1e12,
                 warm_up=300, seconds=40_000, edits_of_loop=(10 ** 6, 10 ** 6))
SMALL = Settings(replicas=5, warm_up=30, seconds=40)


class QueueTest(unittest.TestCase):
    def mean_wait(self, times):
        return figures(Simulation(QUEUE, times))["wait_mean_s"]

    def test_waits_are_those_of_an_m_m_1_queue(self):
        load, seconds = .6, 1.0
        expected = load / (1 - load) * seconds
        self.assertAlmostEqual(self.mean_wait(ExponentialTimes(seconds)) / expected, 1, delta=.08)

    def test_waits_are_those_of_an_m_d_1_queue(self):
        load, seconds = .6, 1.0
        expected = load / (2 * (1 - load)) * seconds
        self.assertAlmostEqual(self.mean_wait(ConstantTimes(seconds)) / expected, 1, delta=.05)

    def test_erlang_c_is_that_of_the_tables(self):
        self.assertAlmostEqual(float(erlang_c(1, .6)), .6)
        self.assertAlmostEqual(float(erlang_c(4, 3.0)), .5094, places=4)


class FailureTest(unittest.TestCase):
    def run_it(self, **changed):
        return figures(Simulation(replace(SMALL, mtbf=.01, **changed), MeasuredTimes()))

    def test_no_edit_that_the_tier_knows_is_lost(self):
        found = self.run_it(disk_lost=1.0)
        self.assertGreater(found["failures"], 0)
        self.assertGreater(found["edits_cut_off"], 0)
        self.assertGreater(found["tier_hits"], 0)
        self.assertEqual(found["edits_lost"], 0)

    def test_what_only_a_lost_store_knew_is_lost(self):
        # So that the count above could be another one. Recipes wait behind packs.
        found = self.run_it(acknowledge="local", disk_lost=1.0, tier_latency=.2)
        self.assertGreater(found["edits_lost"], 0)

    def test_meshes_that_the_tier_has_not_got_are_computed_again(self):
        self.assertGreater(self.run_it(disk_lost=1.0, tier_latency=.2)["edits_recomputed"], 10)

    def test_every_answer_is_one_edit_more_of_its_loop(self):
        simulation = Simulation(replace(SMALL, mtbf=.02, warm_up=0, edits_of_loop=(500, 500)),
                                MeasuredTimes())
        begun = Simulation(replace(SMALL, warm_up=0, seconds=1e-6, edits_of_loop=(500, 500)),
                           MeasuredTimes())
        made = (sum(loop.made for loop in simulation.loops)
                - sum(loop.made for loop in begun.loops))
        self.assertGreater(simulation.failures, 0)
        finished = 500 * (simulation._begun - begun._begun)  # pylint: disable=protected-access
        self.assertEqual(made + finished, len(simulation.waits))


class RoutingTest(unittest.TestCase):
    def test_the_same_seed_gives_the_same_figures(self):
        runs = [figures(Simulation(replace(SMALL, mtbf=.05), MeasuredTimes())) for _ in "ab"]
        self.assertEqual(*runs)
        other = figures(Simulation(replace(SMALL, mtbf=.05, seed=2), MeasuredTimes()))
        self.assertNotEqual(runs[0], other)

    def test_a_hot_route_saturates_its_home_and_a_route_a_loop_does_not(self):
        hot = replace(SMALL, zipf=1.5)
        found = figures(Simulation(hot, MeasuredTimes()))
        self.assertGreater(found["workers_busiest"], .97)
        self.assertLess(found["workers_median"], .7)
        for routing in ("loop", "bounded"):
            spread = figures(Simulation(replace(hot, routing=routing), MeasuredTimes()))
            self.assertLess(spread["workers_busiest"], .85, routing)
            self.assertGreater(spread["edits"], found["edits"], routing)

    def test_loops_of_a_lost_replica_go_to_all_others(self):
        rendezvous = Rendezvous(20)
        routes = [rendezvous.ranks(route) for route in range(20_000)]
        for home in range(20):
            ranks = [each for each in routes if each[0] == home]
            self.assertAlmostEqual(len(ranks) / 1000, 1, delta=.15)
        seconds = [each[1] for each in routes if each[0] == 3]
        self.assertEqual(set(seconds), set(range(20)) - {3})

    def test_shares_follow_zipf(self):
        shares = zipf_shares(1000, 1.0)
        self.assertAlmostEqual(shares.sum(), 1)
        self.assertAlmostEqual(shares[0] / shares[9], 10)


class PlacementTest(unittest.TestCase):
    def test_formulas_tell_what_the_simulation_does(self):
        settings = replace(SMALL, warm_up=60, routing="loop")
        simulated, told = figures(Simulation(settings, MeasuredTimes())), placed(
            settings, MeasuredTimes())
        for name, delta in (("edits_per_hour", .03), ("cores_median", .1),
                            ("tier_requests_a_second", .05), ("tier_MB_a_second", .1)):
            self.assertAlmostEqual(simulated[name] / told[name], 1, delta=delta, msg=name)


if __name__ == "__main__":
    unittest.main()
