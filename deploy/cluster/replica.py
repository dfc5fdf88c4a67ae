"""A replica and the tier, as parts of a discrete-event simulation."""
from array import array

import simpy

READ, COMPUTE = 0, 1  # what gets a core first: a daemon's computations give way


class FluidQueue:
    """First come, first served, at a fixed rate; tells how long what comes now will take."""

    def __init__(self, env, rate):
        self._env, self._rate = env, rate
        self._free_at = 0.0
        self.amount = 0.0  # that was asked for

    def take(self, amount):
        now = self._env.now
        self._free_at = max(self._free_at, now) + amount / self._rate
        self.amount += amount
        return self._free_at - now


class Tier:
    """The shared objects: so many requests and so many bytes a second."""

    def __init__(self, env, settings):
        self._latency = settings.tier_latency
        self.requests = FluidQueue(env, settings.tier_requests)
        self.megabytes = FluidQueue(env, settings.tier_bandwidth)
        self.firsts = set()  # designs whose first mesh it has
        self.count()

    def count(self):
        """Begins to count anew."""
        self.requests.amount = self.megabytes.amount = 0.0
        self.waits = array("d")

    def take(self, requests, size):
        """s until so many requests, one after another, are answered; size: bytes of all."""
        wait = max(self.requests.take(requests), self.megabytes.take(size / 1e6))
        self.waits.append(wait)
        return requests * self._latency + wait


class Replica:
    """One daemon: its cores, its memory, its store and its outbox. Of its generators, an Interrupt
    ends those that wait for a daemon that dies."""

    def __init__(self, env, number, settings, times, shared):
        """shared: a Simulation: its tier, heads, chance and counts."""
        self.number = number
        self.up = True
        self.generation = 0  # of its store: one more each time it is lost
        self.active = {}     # processes of loops that wait for it, as keys, in a fixed order
        self.loops = 0       # that go to it first
        self.firsts = set()  # designs whose first mesh its store has
        self.served = 0      # edits: a clock for what memory holds
        self.outbox = simpy.Store(env)
        self._env, self._settings, self._times, self._shared = env, settings, times, shared
        self._holds = settings.cache * 2 ** 20 / times.held_bytes if times.held_bytes else 1e18
        self.count()
        self._start()

    def count(self):
        """Begins to count anew."""
        self.busy = self.held = 0.0  # s of its cores at work, and of its workers

    def _start(self):
        self._cores = simpy.PriorityResource(self._env, self._settings.cores)
        self._preparers = simpy.Resource(self._env, self._settings.preparers)
        self._writers = [self._env.process(self._write()) for _ in range(self._settings.writers)]

    @property
    def queue(self):
        """Work that waits for a core."""
        return len(self._cores.queue)

    def _use_core(self, seconds, priority):
        with self._cores.request(priority) as turn:
            yield turn
            yield self._env.timeout(seconds)
        self.busy += seconds
        self.held += seconds

    def serve_first(self, design):
        """The first mesh of a loop; many loops may begin with the same."""
        times, tier = self._times, self._shared.tier
        if design in self.firsts:
            yield from self._use_core(times.reading(1), READ)
        elif design in tier.firsts:
            yield self._env.timeout(tier.take(2, times.first_bytes))
            yield from self._use_core(times.reading(1), READ)
        else:
            yield from self._use_core(times.first_s, COMPUTE)
            self.outbox.put(("first", design, 0, times.first_bytes))
        self.firsts.add(design)

    def serve_edit(self, loop):
        """An edit, until it is acknowledged; the s that it waited for a core at the end."""
        yield from self._prepare(loop)
        asked = self._env.now
        seconds, size = self._times.edit(self._shared.chance)
        with self._cores.request(COMPUTE) as turn:
            yield turn
            waited = self._env.now - asked
            begun = self._env.now
            self._shared.tier.take(1, 0)  # has another one made it? computed meanwhile
            yield self._env.timeout(seconds)
            self.busy += seconds
            if self._shared.moves_head():
                yield self._env.timeout(self._shared.heads.take(1))
            if self._settings.acknowledge == "tier":  # for which the worker waits
                yield self._env.timeout(self._shared.tier.take(1, self._times.recipe_bytes))
            self.held += self._env.now - begun
        self._acknowledge(loop, size)
        return waited

    def _prepare(self, loop):
        """Has the base of the next edit in memory."""
        hits = self._shared.hits
        if not loop.is_at(self):
            hits["tier"] += 1
            yield from self._adopt(loop)
        # Of each edit memory keeps the base and what was made of it, used last for longest.
        elif 2 * (self.served - loop.seen) <= self._holds:
            hits["memory"] += 1
        else:
            hits["store"] += 1
            with self._preparers.request() as turn:
                yield turn
                yield from self._use_core(self._times.reading(loop.packs), READ)

    def _adopt(self, loop):
        """Another replica had it, or this one and lost its store: packs come from the tier, and
        what that has not got is computed again of its recipes."""
        here = loop.left_at if loop.was_at(self) else 0  # edits that its store has
        packs = min(loop.packs, loop.made - here)
        with self._preparers.request() as turn:
            yield turn
            if packs > 0:  # a pack and a recipe each
                size = loop.chain_bytes * packs / loop.packs
                size += self._times.first_bytes if packs == loop.packs else 0
                if self._settings.pack_every > 1:
                    packs, size = 1, self._times.first_bytes
                yield self._env.timeout(self._shared.tier.take(2 * packs, size))
            yield from self._use_core(self._times.reading(loop.packs), READ)
        for number in range(max(loop.stored, here) + 1, loop.made + 1):
            seconds, size = self._times.edit(self._shared.chance)
            yield from self._use_core(seconds, COMPUTE)
            self._shared.remade += 1
            self._send_pack(loop, number, size)
        loop.move_to(self)

    def _acknowledge(self, loop, size):
        loop.made += 1
        self.served += 1
        loop.seen = self.served
        if loop.grow_chain(size, self._times.first_bytes) or self._settings.pack_every > 1:
            size = self._times.first_bytes
        if self._settings.acknowledge == "tier":
            loop.known = loop.made
        else:
            self.outbox.put(("recipe", loop, loop.made, self._times.recipe_bytes))
        self._send_pack(loop, loop.made, size)

    def _send_pack(self, loop, number, size):
        if number % self._settings.pack_every == 0:
            self.outbox.put(("pack", loop, number, size))

    def _write(self):
        """Has the tier get what is in the outbox; at an end, what is under way stays in it."""
        tier, outbox = self._shared.tier, self.outbox
        while True:
            request = outbox.get()
            try:
                yield request
                kind, what, number, size = request.value
                if kind != "recipe":  # has it been written?
                    yield self._env.timeout(tier.take(1, 0))
                yield self._env.timeout(tier.take(1, size))
            except simpy.Interrupt:
                request.cancel()
                if request.triggered:
                    outbox.items.insert(0, request.value)
                return
            if kind == "pack":
                what.stored = max(what.stored, number)
            elif kind == "recipe":
                what.known = max(what.known, number)
            else:
                tier.firsts.add(what)

    def fail(self, store_lost):
        """Whoever waits for it gets no answer."""
        self.up = False
        for process in [*self._writers, *self.active]:
            process.interrupt()
        self.active.clear()
        self.served += 10 ** 9  # nothing is in memory any more
        if store_lost:
            self.generation += 1
            self.firsts.clear()
            self.outbox = simpy.Store(self._env)

    def come_back(self):
        self.up = True
        self._start()
