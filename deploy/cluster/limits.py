#!/usr/bin/python3
"""What saturates first: each part that all replicas share, and at how many replicas it is full.

    deploy/cluster/limits.py [--edits-a-replica 40000] [--network 1250] ...

Of measured parts the capacity is one core's, or one database's, of the machine that was measured.
"""
import argparse

from costs import requests_of_edit
from routing import zipf_shares
from service_times import MeasuredTimes

OPTIONS = {  # default, what it is; all of them assumptions
    "edits_a_replica": (40_000, "an hour, 55 to 60 % of four cores"),
    "cores": (4, "of a replica"),
    "network": (1250, "MB/s of the tier's machine"),
    "disk_write": (1000, "MB/s of the tier's machine"),
    "disk": (4, "TB of the tier's machine"),
    "bucket_puts": (3500, "a second, of a bucket that has not been split by prefixes"),
    "bucket_prefixes": (256, "of keys that it can be split by: recipe/00 ..."),
    "bucket_latency": (0.03, "s of a request to a bucket"),
    "designs": (1_000_000, "that loops begin with"),
}


def nginx_cpu_of_edit(times):
    """s of a core of nginx for what an edit asks of the tier."""
    cpu = {name: each["cpu_s"] for name, each in times.told["shared"]["nginx"].items()}
    size = {name: each["bytes"] for name, each in times.told["shared"]["nginx"].items()}
    small, large = "PUT pack", "PUT first_mesh"
    slope = (cpu[large] - cpu[small]) / (size[large] - size[small])
    pack = cpu[small] + slope * (times.pack_bytes - size[small])
    return cpu["PUT recipe"] + 2 * cpu["HEAD pack"] + pack


def shared_parts(times, told):
    """(part, edits a second that it can take, where the figure is from), of the whole cluster."""
    puts, _ = requests_of_edit(told.edits_of_loop)
    megabytes = (times.pack_bytes + times.recipe_bytes) / 1e6
    core = told.cores / times.edit_s
    for exponent in (1.2, 1.0, .8, .6):
        share = zipf_shares(told.designs, exponent)[0]
        yield f"home of the hottest route, Zipf {exponent}", core / share, "calculated"
    yield "nginx as balancer, a core", 1 / times.told["balancer"]["cpu_s_an_edit"], "measured"
    yield "nginx as tier, a core", 1 / nginx_cpu_of_edit(times), "measured"
    yield "tier, writing to its disk", told.disk_write / megabytes, "assumed"
    yield "tier, its network", told.network / megabytes, "assumed"
    yield "bucket, PUTs, not split", told.bucket_puts / puts, "assumed"
    yield "bucket, PUTs, split", told.bucket_puts * told.bucket_prefixes / puts, "assumed"
    heads = times.told["shared"]["postgres_compare_and_sets"]
    yield ("PostgreSQL, a head an edit", max(each["a_second"] for each in heads.values()),
           "measured")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name, (default, text) in OPTIONS.items():
        parser.add_argument("--" + name.replace("_", "-"), type=type(default), default=default,
                            help=text)
    told = parser.parse_args()
    told.edits_of_loop = 120
    times = MeasuredTimes()
    print(f"{'shared part':40s} {'edits/s':>10s} {'edits/h':>12s} {'replicas':>9s}")
    for part, rate, source in sorted(shared_parts(times, told), key=lambda row: row[1]):
        print(f"{part:40s} {rate:10,.0f} {3600 * rate:12,.0f} "
              f"{3600 * rate / told.edits_a_replica:9,.0f}  {source}")
    megabytes = (times.pack_bytes + times.recipe_bytes) / 1e6
    bucket = 1 / (2 * told.bucket_latency + megabytes / told.network)
    nginx = times.told["shared"]["nginx"]
    beside = 1 / (nginx["HEAD pack"]["wall_s"] + nginx["PUT pack"]["wall_s"])
    print(f"\none replica: its cores {told.cores / times.edit_s:.1f} edits/s, its writer of packs "
          f"{bucket:.1f} to a bucket, {beside:,.0f} to an nginx beside it")
    hours = told.disk * 1e6 / (1e6 * megabytes)
    print(f"a million edits an hour fill {told.disk} TB in {hours:.1f} h")
    for count, each in times.told["shared"]["client_lists"].items():
        print(f"a client that knows {int(count):6,d} replicas: {each['connect_s']:.2f} s to "
              f"connect, {1e3 * each['rank_s']:.2f} ms a request, "
              f"{each['resident_bytes'] / 1e6:.0f} MB")


if __name__ == "__main__":
    main()
