#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plans the matching of all pairs of a large collection on a cluster: time, memory and traffic, by simulation.

  plan_collection.py [--shapes 10000] [--processes 1,16,64,256] [--measure PROGRAM FOLDER]

Simulates how `shape_correspondence_mpi collection` hands bands of rows to processes that become free. The costs of a graph and of a pair are
those of an earlier measurement, or are measured on the shapes of a folder, graphs best. Building the graphs of models is not part of the plan.
"""
import argparse
import heapq
import os
import resource
import subprocess
import tempfile
from types import SimpleNamespace

# Of `src/cli/collection_work.cpp`
LEAST_BLOCK, LARGEST_BLOCK, BLOCKS_OF_PROCESS = 4, 64, 8

# Of 100 generated shapes with 14 parts each: seconds to read and prepare a graph, seconds for an ordered pair, bytes of a graph and of a pair
MEASURED = SimpleNamespace(graph=1.9e-3, pair=1.6e-4, graph_bytes=53e3, pair_bytes=120)
MEMORY_OF_SHAPE = 0.7e6  # bytes of a graph and what is prepared of it
MEMORY_OF_PROGRAM = 30e6


def processor_seconds(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def size_of(folder):
    return sum(os.path.getsize(os.path.join(folder, name)) for name in os.listdir(folder))


def measure(program, folder):
    """Costs on the shapes of a folder, in one thread: matched, and read again from the finished store."""
    with tempfile.TemporaryDirectory() as scratch:
        store = os.path.join(scratch, "store")
        command = [program, "collection", folder, "--quiet", "--threads", "1", "--store", store, "--json", os.path.join(scratch, "c.json")]
        matched = processor_seconds(command)
        kept = processor_seconds(command)  # reads all graphs once, and analyses
        n = len(os.listdir(os.path.join(store, "graphs")))
        pairs = n * (n - 1)
        graph = kept / (2 * n)  # an upper bound: the analysis is in it
        return SimpleNamespace(graph=graph, pair=(matched - kept) / pairs, graph_bytes=size_of(os.path.join(store, "graphs")) / n,
                               pair_bytes=size_of(os.path.join(store, "pairs")) / pairs)


def band_size(shapes, processes):
    blocks = BLOCKS_OF_PROCESS * processes
    return min(max((shapes + blocks - 1) // blocks, LEAST_BLOCK), LARGEST_BLOCK)


def plan(shapes, processes, costs):
    """Seconds until the last process has ended, busy seconds of all, and bytes read."""
    size = band_size(shapes, processes)
    free = [0.0] * processes
    busy, read = 0.0, 0.0
    for first in range(0, shapes - 1, size):
        rows = min(size, shapes - 1 - first)
        columns = shapes - 1 - first
        pairs = sum(2 * (shapes - 1 - row) for row in range(first, first + rows))
        seconds = (rows + columns) * costs.graph + pairs * costs.pair
        busy += seconds
        read += (rows + columns) * costs.graph_bytes
        heapq.heapreplace(free, free[0] + seconds)
    return max(free), busy, read


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shapes", type=int, default=10000)
    parser.add_argument("--processes", default="1,16,64,256")
    parser.add_argument("--measure", nargs=2, metavar=("PROGRAM", "FOLDER"))
    args = parser.parse_args()
    costs = measure(*args.measure) if args.measure else MEASURED
    print(f"{1e3 * costs.graph:.2f} ms a graph, {1e3 * costs.pair:.3f} ms an ordered pair, {costs.graph_bytes / 1e3:.0f} kB a graph, "
          f"{costs.pair_bytes:.0f} B a pair")
    print(f"store {(args.shapes * costs.graph_bytes + args.shapes * (args.shapes - 1) * costs.pair_bytes) / 1e9:.1f} GB; first process at "
          f"the end {16 * args.shapes**2 / 1e9:.1f} GB for distances; each process "
          f"{(MEMORY_OF_PROGRAM + 2 * LARGEST_BLOCK * MEMORY_OF_SHAPE) / 1e6:.0f} MB")
    print("processes   rows a band    hours   busy share   GB read")
    for processes in map(int, args.processes.split(",")):
        wall, busy, read = plan(args.shapes, processes, costs)
        print(f"{processes:>9}{band_size(args.shapes, processes):>14}{wall / 3600:>9.2f}{busy / wall / processes:>13.2f}{read / 1e9:>10.0f}")


if __name__ == "__main__":
    main()
