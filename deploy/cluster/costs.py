#!/usr/bin/python3
"""What a million edits take, and what they cost by prices that are given.

    deploy/cluster/costs.py [--core-hour 0.04] [--pack-every 8] [--packs-days 7] ...

Amounts are measured; prices, days and the share of cores that is used are round numbers to be
changed by options, not any vendor's.
"""
import argparse

from service_times import MeasuredTimes

OPTIONS = {  # default, what it is
    "core_hour": (0.04, "price of a core with 4 GB for an hour"),
    "gb_month": (0.023, "price of a GB in the tier for a month"),
    "million_puts": (5.0, "price of a million PUTs"),
    "million_gets": (0.4, "price of a million GETs or HEADs"),
    "gb_out": (0.09, "price of a GB to clients outside; 0 for those beside the replicas"),
    "used": (0.6, "share of the cores that is at work"),
    "missed": (0.1, "share of bases that are read from the replica's store"),
    "edits_of_loop": (120, "after its first mesh"),
    "packs_days": (7, "for which the tier keeps meshes"),
    "recipes_days": (365, "for which it keeps recipes"),
    "pack_every": (1, "edits, of which the tier gets one's mesh; above 1 a whole one"),
    "edits": (1_000_000, "to be counted"),
}


def requests_of_edit(edits_of_loop, pack_every=1):
    """(PUTs, GETs and HEADs) to the tier. PUT of the recipe and of the pack, before it HEAD, and
    HEAD for the mesh while it is computed; those of a first mesh are spread over its loop."""
    first = 1 / edits_of_loop
    return (1 + 1 / pack_every) + 2 * first, (1 + 1 / pack_every) + 3 * first


def amounts(times, told):
    """Of all edits together, by name."""
    first = 1 / told.edits_of_loop
    pack = times.pack_bytes if told.pack_every == 1 else times.first_bytes / told.pack_every
    packs = 1 + times.first_bytes / times.delta_bytes
    seconds = (times.edit_s + told.missed * times.reading(packs) + first * times.first_s)
    puts, gets = requests_of_edit(told.edits_of_loop, told.pack_every)
    return {"core hours": told.edits * seconds / 3600 / told.used,
            "PUTs, millions": told.edits * puts / 1e6,
            "GETs and HEADs, millions": told.edits * gets / 1e6,
            "GB of meshes": told.edits * (pack + first * times.first_bytes) / 1e9,
            "GB of recipes": told.edits * (1 + first) * times.recipe_bytes / 1e9,
            "GB to clients": told.edits * (times.answer_bytes
                                           + first * times.first_answer_bytes) / 1e9}


def prices(told):
    return {"core hours": told.core_hour, "PUTs, millions": told.million_puts,
            "GETs and HEADs, millions": told.million_gets,
            "GB of meshes": told.gb_month * told.packs_days / 30,
            "GB of recipes": told.gb_month * told.recipes_days / 30, "GB to clients": told.gb_out}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name, (default, text) in OPTIONS.items():
        parser.add_argument("--" + name.replace("_", "-"), type=type(default), default=default,
                            help=f"{text} ({default})")
    told = parser.parse_args()
    times = MeasuredTimes()
    found, price = amounts(times, told), prices(told)
    print(f"{told.edits:,d} edits{'':18s} {'amount':>10s} {'price':>8s} {'cost':>8s}")
    for name, amount in found.items():
        print(f"{name:31s} {amount:10,.1f} {price[name]:8.3f} {amount * price[name]:8.2f}")
    print(f"{'together':50s} {sum(amount * price[name] for name, amount in found.items()):8.2f}")
    one = times.edit_s / 3600 * told.core_hour / told.used
    kept = times.pack_bytes / 1e9 * told.gb_month / 30
    print(f"\na million edits computed again: {1e6 * one:.2f}; their packs written: "
          f"{told.million_puts + told.million_gets:.2f}, kept for a day: {1e6 * kept:.2f}")
    stored = found["GB of meshes"] + found["GB of recipes"]
    print(f"{told.edits:,d} edits an hour: {24 * stored / 1e3:.1f} TB a day to the tier, "
          f"{24 * found['GB to clients'] / 1e3:.1f} TB to clients, {found['core hours']:.0f} cores")


if __name__ == "__main__":
    main()
