#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program on models that were not prepared for it.

  wild_models.py BUILD OUT FOLDER... [--install] [--step N] [--seconds S] [--megabytes M] [--jobs J]

BUILD is the build folder, FOLDERs hold models in sub-folders of any depth. With --install, OUT/installed is one of them: Debian's
packages sweethome3d-furniture, flightgear-data-ai and assimp-testmodels, which has files of all types (apt-get, as root).

Makes a structural graph of every N-th model, each in a process that may take S seconds of processor time and M megabytes, and
writes OUT/models.csv: read or refused and why, parts, seconds, megabytes; and a summary of each folder in the FOLDERs to standard output.
"""
import argparse
import collections
import concurrent.futures
import csv
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
import zipfile

MODEL_TYPES = (".obj", ".ac", ".gltf", ".glb", ".dae", ".fbx", ".3ds", ".dxf", ".ply", ".stl", ".off")
WAITING = 10  # limit of wall-clock time over that of processor time, for busy machines
PACKAGES = ("sweethome3d-furniture", "flightgear-data-ai", "assimp-testmodels")


def install(folder):
    """Unpacks the models of packages into a folder, unless it is there."""
    if os.path.isdir(folder):
        return
    subprocess.run(["apt-get", "install", "-y", "--no-install-recommends", *PACKAGES], check=True)
    os.makedirs(folder)
    for package in PACKAGES:
        files = subprocess.run(["dpkg", "-L", package], check=True, capture_output=True, text=True).stdout.split("\n")
        for file in files:
            if file.endswith(".sh3f"):
                with zipfile.ZipFile(file) as archive:
                    archive.extractall(os.path.join(folder, package, os.path.basename(file)[:-5]))
            elif os.path.isfile(file) and not file.startswith("/usr/share/doc"):  # textures and buffers, too
                target = os.path.join(folder, package, os.path.relpath(file, "/usr/share"))
                os.makedirs(os.path.dirname(target), exist_ok=True)
                os.symlink(file, target)


def models_in(folders):
    found = []
    for folder in folders:
        for path, _, names in os.walk(folder):
            found += [os.path.join(path, name) for name in names if name.lower().endswith(MODEL_TYPES)]
    return sorted(found)


def run_limited(command, seconds, megabytes):
    """Runs a command. Returns its exit status, None if it took too long; standard output and error; seconds of processor time;
    megabytes."""
    def limit():
        resource.setrlimit(resource.RLIMIT_DATA, (megabytes << 20, megabytes << 20))
        resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds)))
    begin = time.monotonic()
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as error:
        process = subprocess.Popen(command, stdout=out, stderr=error, preexec_fn=limit)
        status = None
        while time.monotonic() - begin < WAITING * seconds:
            pid, state, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                status = os.waitstatus_to_exitcode(state)
                break
            time.sleep(0.02)
        else:
            process.kill()
            _, _, usage = os.wait4(process.pid, 0)
        process.returncode = status  # tells Popen that wait4() has reaped the process
        if status == -signal.SIGKILL or status == -signal.SIGXCPU:
            status = None
        out.seek(0)
        error.seek(0)
        return (status, out.read().decode(errors="replace"), error.read().decode(errors="replace"),
                usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024)


def graph_row(program, model, args):
    status, out, error, seconds, megabytes = run_limited(
        [program, "graph", model, "--json", "-", "--threads", "1", "--cache", os.path.join(args.out, "cache"),
         "--time-limit", "10"], args.seconds, args.megabytes)
    row = {"model": model, "result": "graph", "parts": "", "seconds": round(seconds, 2), "megabytes": round(megabytes),
           "why": ""}
    if status == 0:
        graph = json.loads(out)
        row["parts"] = len(graph["parts"])
        row["why"] = " ".join(w for w in graph.get("warnings", []) if "split" in w or "one piece" in w)
    elif status is None:
        row["result"], row["why"] = "time", f"more than {args.seconds} s"
    elif status == 1:
        row["result"], row["why"] = "refused", error.strip().replace(model, "")
    else:
        row["result"], row["why"] = "crash", f"exit status {status}"
    return row


def survey(args, folders, models):
    program = os.path.join(args.build, "shape_correspondence")
    chosen = models[:: args.step]
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        rows = list(pool.map(lambda model: graph_row(program, model, args), chosen))
    with open(os.path.join(args.out, "models.csv"), "w", newline="") as file:
        table = csv.DictWriter(file, rows[0].keys())
        table.writeheader()
        table.writerows(rows)
    libraries = collections.defaultdict(list)
    for row in rows:
        folder = next(f for f in folders if row["model"].startswith(os.path.join(f, "")))
        libraries[os.path.relpath(os.path.dirname(row["model"]), folder).split(os.sep)[0]].append(row)
    for library, of_library in libraries.items():
        print_survey(library, of_library)


def print_survey(library, rows):
    counts = collections.Counter(row["result"] for row in rows)
    print(f"{library}: {len(rows)} models: " + ", ".join(f"{n} {result}" for result, n in counts.most_common()))
    for why, n in collections.Counter(row["why"] for row in rows if row["result"] != "graph").most_common():
        print(f"  {n:4}  {why}")
    graphs = [row for row in rows if row["result"] == "graph"]
    for value in ("parts", "seconds", "megabytes") if graphs else ():
        values = sorted(row[value] for row in graphs)
        print(f"  {value}: median {values[len(values) // 2]}, most {values[-1]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("out")
    parser.add_argument("folders", nargs="*")
    parser.add_argument("--install", action="store_true")
    parser.add_argument("--step", type=int, default=1, help="take every N-th model")
    parser.add_argument("--seconds", type=float, default=120)
    parser.add_argument("--megabytes", type=int, default=2048)
    parser.add_argument("--jobs", type=int, default=1)
    args = parser.parse_args()
    os.makedirs(args.out, exist_ok=True)
    folders = list(args.folders)
    if args.install:
        folders.append(os.path.join(args.out, "installed"))
        install(folders[-1])
    models = models_in(folders)
    if not models:
        sys.exit("there is no model; name a folder, or --install some")
    survey(args, folders, models)


if __name__ == "__main__":
    main()
