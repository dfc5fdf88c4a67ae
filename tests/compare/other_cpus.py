#!/usr/bin/python3
"""Whether the engine makes the same meshes on other CPUs.

    tests/compare/other_cpus.py build/bin/remesh-digests [--qemu qemu-x86_64] [ARGUMENT...]

Digests of meshes (`remesh-digests ARGUMENT...`) as this CPU makes them, beside those with the
variants of the C library for CPUs without fused multiply-add, AVX2 and AVX, and, with --qemu, those
of an emulated CPU of 2003, the first of x86-64. Exits with 1 where one differs.
"""
import argparse
import os
import subprocess
import sys

HWCAPS = {"no FMA": "-FMA,-FMA4,-FMA_Usable,-FMA4_Usable",
          "no FMA, AVX2, AVX": "-FMA,-FMA4,-AVX2,-AVX,-AVX512F,-FMA_Usable,-AVX2_Usable,-AVX_Usable"}
FIRST_CPU = "Opteron_G1"


def digests(command, hwcaps=""):
    environment = dict(os.environ)
    environment.pop("GLIBC_TUNABLES", None)
    if hwcaps:
        environment["GLIBC_TUNABLES"] = f"glibc.cpu.hwcaps={hwcaps}"
    return subprocess.run(command, env=environment, check=True, stdout=subprocess.PIPE,
                          text=True).stdout.splitlines()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="remesh-digests")
    parser.add_argument("--qemu", help="qemu-x86_64")
    known, arguments = parser.parse_known_args()
    command = [known.program, *arguments]
    here = digests(command)
    runs = {name: lambda caps=caps: digests(command, caps) for name, caps in HWCAPS.items()}
    if known.qemu:
        runs[FIRST_CPU] = lambda: digests([known.qemu, "-cpu", FIRST_CPU, *command])
    differ = 0
    for name, run in runs.items():
        there = run()
        different = [line for line in here if line not in set(there)]
        print(f"{name}: {len(here) - len(different)} of {len(here)} meshes the same", *different,
              sep="\n  ", flush=True)
        differ += len(different)
    return 1 if differ or not here else 0


if __name__ == "__main__":
    sys.exit(main())
