#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks and times the command collection on a folder of shapes, preferably of graphs.

  benchmark_collection.py PROGRAM FOLDER [--kills 20] [--threads 1,2] [--ranks 2,4] [--rank-kills 1] [--options "--roles none"]

Every run must write the same bytes. Kills: a run is killed (SIGKILL) at random moments and started again until it ends; no finished
row may be computed again, so that a kill costs at most the rows in progress. Ranks need PROGRAM_mpi, built with MPI, beside it;
they share the processors. Rank kills: one rank is killed, and all are started again. Prints seconds on the wall and of CPU. Ends
with exit status 1 if a run differs.
"""
import argparse
import os
import random
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import time


class Runs:
    def __init__(self, args, scratch):
        self.args, self.scratch, self.expected, self.failed = args, scratch, None, False
        self.output = os.path.join(scratch, "collection.json")

    def command(self, *more, program=""):
        return [os.path.abspath(self.args.program) + program, "collection", self.args.folder, "--quiet", "--json", self.output,
                *shlex.split(self.args.options), *more]

    def timed(self, name, command):
        before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.time()
        subprocess.run(command, check=True)
        after, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.time() - begin
        cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        print(f"{name:<24}{wall:>10.2f} s{cpu:>10.2f} s CPU   {self.verdict()}", flush=True)
        return wall

    def verdict(self):
        with open(self.output, "rb") as file:
            result = file.read()
        os.remove(self.output)
        if self.expected is None:
            self.expected = result
        if result == self.expected:
            return "same bytes"
        self.failed = True
        return "OTHER BYTES"

    def kill(self, moments, usual_seconds):
        store = os.path.join(self.scratch, "killed")
        rows, redone, survived = {}, 0, 0
        for moment in moments:
            process = subprocess.Popen(self.command("--store", store))
            time.sleep(moment * usual_seconds)
            process.send_signal(signal.SIGKILL)
            survived += process.wait() == 0
            found = self.rows(store)
            redone += sum(found.get(name) != stamp for name, stamp in rows.items())
            rows = found
        subprocess.run(self.command("--store", store), check=True)
        found = self.rows(store)
        redone += sum(found.get(name) != stamp for name, stamp in rows.items())
        self.failed |= redone > 0
        print(f"{len(moments)} kills, {survived} too late; {len(found)} rows, {redone} finished ones done again; {self.verdict()}")

    def on_ranks(self, n, store):
        mpirun = ["mpirun", "--bind-to", "none", "--allow-run-as-root", "--oversubscribe", "-n", str(n)]
        return mpirun + self.command("--store", store, program="_mpi")

    def kill_rank(self, n, moment):
        store = os.path.join(self.scratch, f"rank_killed{n}_{moment:.2f}")
        run = subprocess.Popen(self.on_ranks(n, store), stderr=subprocess.DEVNULL)
        time.sleep(moment)
        ranks = [pid for pid, words in commands() if words[0].endswith("_mpi") and store in words]
        if ranks:
            os.kill(max(ranks), signal.SIGKILL)
        stopped = run.wait() != 0
        subprocess.run(self.on_ranks(n, store), check=True)
        print(f"one of {n} ranks killed{'' if stopped else ', too late'}; {self.verdict()}")

    @staticmethod
    def rows(store):
        folder = os.path.join(store, "pairs")
        names = [n for n in os.listdir(folder) if n.endswith(".row")] if os.path.isdir(folder) else []
        stats = {n: os.stat(os.path.join(folder, n)) for n in names}
        return {n: (s.st_ino, s.st_mtime_ns) for n, s in stats.items()}


def commands():
    """The processes of this machine and their command lines."""
    for entry in os.listdir("/proc"):
        if not entry.isdigit():
            continue
        try:
            with open(f"/proc/{entry}/cmdline", encoding="utf-8", errors="replace") as file:
                yield int(entry), file.read().split("\0")
        except OSError:  # the process has ended
            continue


def numbers(text):
    return [int(word) for word in text.split(",") if word]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--threads", default="1,2")
    parser.add_argument("--ranks", default="")
    parser.add_argument("--rank-kills", type=int, default=0)
    parser.add_argument("--options", default="")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        runs = Runs(args, scratch)
        seconds = [runs.timed(f"{n} threads", runs.command("--threads", str(n))) for n in numbers(args.threads)]
        for n in numbers(args.ranks):
            wall = runs.timed(f"{n} ranks", runs.on_ranks(n, os.path.join(scratch, f"ranks{n}")))
            for k in range(args.rank_kills):
                runs.kill_rank(n, (k + 1) / (args.rank_kills + 1) * wall)
        if args.kills:
            chance = random.Random(1)
            runs.kill([chance.uniform(0, 1) / 5 for _ in range(args.kills)], max(seconds, default=1))
        sys.exit(1 if runs.failed else 0)


if __name__ == "__main__":
    main()
