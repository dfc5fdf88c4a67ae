"""What is simulated: the size of the cluster, its load, its limits and its failures."""
from dataclasses import dataclass


@dataclass
class Settings:
    replicas: int = 10
    cores: int = 4                 # of a replica; as many workers
    edits_per_hour: float = 0.0    # asked for; 0: 40,000 a replica, some 55 % of its cores
    designs: int = 0               # that loops begin with; 0: 1,000 a replica
    zipf: float = 0.8              # exponent: how much more popular some designs are
    routing: str = "design"        # design | loop | spread | bounded
    routes: int = 8                # of a design, where routing is `spread`
    bound: float = 1.25            # of the mean number of loops of a replica, where it is `bounded`
    edits_of_loop: tuple = (40, 200)
    least_think: float = 5.0       # s between an answer and the next edit, at least
    think: float = 30.0            # s, mean
    cache: float = 8192.0          # MiB of revisions in memory of a replica (--cache)
    queue: int = 64                # edits that may wait for a core (--queue)
    preparers: int = 4             # reads of bases at a time
    acknowledge: str = "tier"      # tier | local
    tier_requests: float = 10_000  # a second that the tier answers
    tier_bandwidth: float = 1250   # MB/s, in and out together
    tier_latency: float = 0.001    # s of a request that waits for nothing
    pack_every: int = 1            # edits, of which the tier gets one's mesh; above 1: whole
    writers: int = 1               # packs at a time that a replica writes to the tier
    mtbf: float = 0.0              # h between failures of a replica; 0: none
    down: float = 30.0             # s until it is there again
    disk_lost: float = 0.5         # share of the failures after which its store is empty
    detect: float = 0.05           # s until a client knows that a request got no answer
    zone_at: float = 0.0           # s after the warm-up when a zone fails; 0: never
    zones: int = 3
    heads: float = 0.0             # share of edits that move a head by compare-and-set
    heads_a_second: float = 3000   # compare-and-sets of the database
    warm_up: float = 60.0          # s that are not counted
    seconds: float = 120.0         # s that are
    seed: int = 1

    def __post_init__(self):
        self.designs = self.designs or 1000 * self.replicas

    def rate(self):
        """Edits a second that are asked for."""
        return (self.edits_per_hour or 40_000 * self.replicas) / 3600
