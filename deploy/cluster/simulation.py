"""Loops of edits on replicas that fail, by discrete events."""
import random
from array import array
from collections import Counter

import simpy

from replica import FluidQueue, Replica, Tier
from routing import Popularity, Rendezvous
from settings import Settings

MOST_PACKS, MOST_SHARE = 64, 2  # of a chain: packs, and bytes by those of a whole mesh
BUCKET = 5.0  # s of a row of the course


class Loop:
    """A first mesh and its edits, one after another; edits are counted from its first mesh on."""

    __slots__ = ("design", "ranks", "edits", "made", "known", "stored", "packs", "chain_bytes",
                 "seen", "home", "generation", "before", "left_at")

    def begin(self, design, ranks, edits):
        self.design, self.ranks, self.edits = design, ranks, edits
        self.made = 0    # acknowledged
        self.known = 0   # whose recipes the tier has
        self.stored = 0  # whose packs it has
        self.packs, self.chain_bytes = 1, 0.0
        self.seen = 0    # Replica.served at its last edit
        self.home, self.generation = ranks[0], ranks[0].generation
        self.before, self.left_at = None, 0

    def is_at(self, replica):
        return self.home is replica and self.generation == replica.generation

    def was_at(self, replica):
        return self.before == (replica, replica.generation)

    def move_to(self, replica):
        self.before, self.left_at = (self.home, self.generation), self.made
        self.home, self.generation = replica, replica.generation

    def grow_chain(self, size, whole):
        """By a pack of that size; whether it is a whole one instead."""
        if self.packs >= MOST_PACKS or self.chain_bytes > MOST_SHARE * whole > 0:
            self.packs, self.chain_bytes = 1, 0.0
            return True
        self.packs += 1
        self.chain_bytes += size
        return False


class Simulation:
    """Runs in its constructor; afterwards its members tell what was counted."""

    def __init__(self, settings: Settings, times):
        self.settings, self.times = settings, times
        self.chance = random.Random(settings.seed)
        self._fate = random.Random(f"failures {settings.seed}")  # the same whatever the load
        self.env = simpy.Environment()
        self.tier = Tier(self.env, settings)
        self.heads = FluidQueue(self.env, settings.heads_a_second)
        self.lost = 0  # acknowledged edits that nobody knows any more, also while it warms up
        self._count()
        self.replicas = [Replica(self.env, number, settings, times, self)
                         for number in range(settings.replicas)]
        self._rendezvous = Rendezvous(settings.replicas)
        self._popularity = Popularity(settings.designs, settings.zipf)
        self._begun = 0
        self.loops = [Loop() for _ in range(max(1, round(
            settings.rate() * (settings.think + times.edit_s))))]
        for loop in self.loops:
            self._place(loop)
            self.env.process(self._run(loop))
        self._start_failures()
        if settings.warm_up > 0:
            self.env.run(until=settings.warm_up)
        self._count()
        for part in [self.tier, *self.replicas]:
            part.count()
        self.env.process(self._note_course())
        self.env.run(until=settings.warm_up + settings.seconds)

    def _count(self):
        """Begins to count anew."""
        self.waits, self.latencies = array("d"), array("d")
        self.hits = Counter()
        self.remade = self.refused = self.broken = self.stalled = self.failures = 0
        self.course = []  # (s, latencies, MB of the tier) of each bucket

    def moves_head(self):
        return self.settings.heads > 0 and self.chance.random() < self.settings.heads

    # Loops.

    def _place(self, loop):
        """In the middle of a loop, with a chain of packs as long as they come."""
        self._begin(loop)
        done = self.chance.randrange(loop.edits)
        loop.made = loop.known = loop.stored = done
        loop.chain_bytes = self.chance.uniform(0, MOST_SHARE) * self.times.first_bytes
        if self.times.delta_bytes:
            loop.packs = 1 + min(done, round(loop.chain_bytes / self.times.delta_bytes))
        self.tier.firsts.add(loop.design)
        loop.home.firsts.add(loop.design)

    def _begin(self, loop):
        design = self._popularity.draw(self.chance)
        self._begun += 1
        loop.begin(design, self._ranks(design), self.chance.randint(*self.settings.edits_of_loop))
        loop.ranks[0].loops += 1

    def _ranks(self, design):
        """The replicas that a new loop of a design goes to, in that order."""
        settings = self.settings
        route = {"design": design, "bounded": design,
                 "spread": design * settings.routes + self._begun % settings.routes,
                 "loop": self._begun}[settings.routing]
        if settings.routing != "bounded":
            return [self.replicas[each] for each in self._rendezvous.ranks(route)]
        most = settings.bound * (len(self.loops) / len(self.replicas) + 1)
        while True:  # past those that are full; further ranks come of a further hash
            ranks = [self.replicas[each] for each in self._rendezvous.ranks(route)]
            for n, replica in enumerate(ranks):
                if replica.loops < most:
                    return ranks[n:] + ranks[:n]
            route += settings.designs

    def _think(self):
        least = self.settings.least_think
        return least + self.chance.expovariate(1 / (self.settings.think - least))

    def _rest_of_think(self):
        """Of a think time that one comes upon."""
        least, mean = self.settings.least_think, self.settings.think
        begun = self.chance.uniform(0, least) if self.chance.random() < least / mean else 0
        return begun + self.chance.expovariate(1 / (mean - least))

    def _run(self, loop):
        env, me = self.env, self.env.active_process
        yield env.timeout(self._rest_of_think())
        while True:
            while loop.made < loop.edits:
                asked = env.now
                waited = yield from self._answer(loop, me, False)
                self.waits.append(waited)
                self.latencies.append(env.now - asked)
                yield env.timeout(self._think())
            loop.ranks[0].loops -= 1
            self._begin(loop)
            yield from self._answer(loop, me, True)
            yield env.timeout(self._think())

    def _answer(self, loop, me, first):
        """Asks one replica after another until the edit, or the first mesh, is acknowledged."""
        env = self.env
        while True:
            replica = self._choice(loop)
            if replica is None:
                self.stalled += 1
                yield env.timeout(1.0)
                continue
            if replica.queue >= self.settings.queue:
                self.refused += 1
                yield env.timeout(self.chance.uniform(.8, 1.2) * max(
                    .1, replica.queue * self.times.edit_s / self.settings.cores))
                continue
            replica.active[me] = True
            try:
                if first:
                    yield from replica.serve_first(loop.design)
                    loop.home, loop.generation = replica, replica.generation
                    waited = 0.0
                else:
                    waited = yield from replica.serve_edit(loop)
                replica.active.pop(me, None)
                return waited
            except simpy.Interrupt:
                self.broken += 1
            yield env.timeout(self.settings.detect)

    def _choice(self, loop):
        """The replica to ask now; None: there is none that could answer."""
        if loop.known < loop.made:  # by recipes, the tier does not know where the loop is
            if loop.generation == loop.home.generation:
                return loop.home if loop.home.up else None
            self.lost += loop.made - loop.known
            loop.made = loop.known
            loop.stored = min(loop.stored, loop.made)
        return next((replica for replica in loop.ranks if replica.up), None)

    # Failures.

    def _start_failures(self):
        settings = self.settings
        if settings.mtbf > 0:
            for replica in self.replicas:
                self.env.process(self._fail_at_times(replica))
        if settings.zone_at > 0:
            for replica in self.replicas[::settings.zones]:
                self.env.process(self._fail(replica, settings.warm_up + settings.zone_at))

    def _fail_at_times(self, replica):
        while True:
            yield from self._fail(replica, self._fate.expovariate(1 / (3600 * self.settings.mtbf)))

    def _fail(self, replica, after):
        yield self.env.timeout(after)
        if not replica.up:
            return
        self.failures += 1
        replica.fail(self._fate.random() < self.settings.disk_lost)
        yield self.env.timeout(self.settings.down)
        replica.come_back()

    def _note_course(self):
        while True:
            edits, megabytes = len(self.latencies), self.tier.megabytes.amount
            yield self.env.timeout(BUCKET)
            self.course.append((self.env.now - self.settings.warm_up, self.latencies[edits:],
                                self.tier.megabytes.amount - megabytes))
