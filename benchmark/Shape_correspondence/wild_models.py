#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Models as people have them: what the program makes of files that nobody prepared.

  wild_models.py BUILD OUT FOLDER... [--install] [--step N] [--seconds S] [--megabytes M] [--jobs J]
  wild_models.py BUILD OUT FOLDER... --labelled DATA... [--category chair,table] [--options "--roles none"] [--step N] [--turned]
  wild_models.py BUILD OUT FOLDER... --labelled DATA... --folds N [--generated DATA] ...
  wild_models.py BUILD OUT FOLDER... --pairs FILE

BUILD is the build folder, FOLDERs hold models in sub-folders of any depth. With --install, OUT/installed is one of them: Debian's
packages sweethome3d-furniture, flightgear-data-ai and assimp-testmodels, which has files of all types (apt-get, as root).

The first form makes a structural graph of every N-th model, each in a process that may take S seconds of processor time and M megabytes, and
writes OUT/models.csv: read or refused and why, parts, seconds, megabytes; and a summary of each folder in the FOLDERs to standard output.

The second form takes models that are also in DATA, a folder of labelled shapes (CATEGORY/SHAPE/parts, labels.json,
pairs.json): SHAPE ends in the name of the model. It compares parts (Rand indices and F1 by surface samples), then
matches the pairs of pairs.json from raw files and from labelled parts, and evaluates both on labelled parts: those of which a
part of the raw shape has the most surface correspond as it does. --labelled can be repeated; all goes to a folder of OUT for
each DATA. --options are for match; roles that were learned from the same shapes know their labelled parts, so `--roles none`
is fair. It also tells which raw models face another side than labelled ones do. With --turned, the target of every raw pair
is turned to z up, and the program finds the upright axes.

With --folds, roles are learned, too: the shapes of all DATA are divided into N folds, each category evenly, and a pair is
matched with roles that were learned from all folds but those of its two shapes, and from the shapes of --generated
(generate_models --benchmark). They have not seen these two, but others of their category.

Matches and role models that are in OUT are not made again: take another OUT for other options, data or programs.

The last form matches pairs of models without options, and takes pictures of the pages: OUT/pairs/*.png. Each line of FILE has a
category, two models as LIBRARY/NAME, and how the second one is turned (wild_pairs.txt).
"""
import argparse
import collections
import concurrent.futures
import csv
import glob
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
import zipfile

from contact_sheet import screenshot

MODEL_TYPES = (".obj", ".ac", ".gltf", ".glb", ".dae", ".fbx", ".3ds", ".dxf", ".ply", ".stl", ".off")
WAITING = 10  # times as long as it may work a process may take, on a busy machine
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
        process.returncode = status  # it is waited for
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


def plain(name):
    return "".join(c for c in name.lower() if c.isalnum())


def raw_models_of(shapes, models):
    """The model of every labelled shape that has one: the longest name that the shape's ends in, in a library of its own."""
    by_name = collections.defaultdict(list)
    for model in models:
        by_name[plain(os.path.splitext(os.path.basename(model))[0])].append(model)
    found = {}
    for shape, source in shapes.items():
        name = shape.split("_", 2)[-1]
        same = by_name.get(plain(name), [])
        same = [m for m in same if len(same) == 1 or any(plain(word) in plain(source) for word in m.split(os.sep)[-5:-2])]
        if same:
            found[shape] = same[0]
    return found


Labelled_shape = collections.namedtuple("Labelled_shape", "category folder source")


def labelled_shapes(data, categories=()):
    shapes = {}
    for file in sorted(glob.glob(os.path.join(data, "*", "*", "labels.json"))):
        with open(file) as text:
            labels = json.load(text)
        if not categories or labels["category"] in categories:
            shapes[labels["id"]] = Labelled_shape(labels["category"], os.path.dirname(file), labels.get("source", ""))
    return shapes


def pairs_of(data):
    with open(os.path.join(data, "pairs.json")) as file:
        return json.load(file)


class Fold_roles:
    """Role models that were each learned without the folds of two shapes."""

    def __init__(self, args):
        self.program, self.out = os.path.join(args.build, "shape_correspondence"), args.out
        self.generated = args.generated
        self.sets = [(data, labelled_shapes(data)) for data in args.labelled]
        self.folds = {}
        numbers = collections.Counter()
        for _, shapes in self.sets:
            for name, shape in shapes.items():
                self.folds[name] = numbers[shape.category] % args.folds
                numbers[shape.category] += 1

    def without(self, *names):
        """The file of the role model for these shapes, which is made if it is not there."""
        folds = sorted({self.folds[name] for name in names})
        file = os.path.join(self.out, "without_" + "_".join(map(str, folds)) + ".roles")
        if not os.path.exists(file):
            with tempfile.TemporaryDirectory() as folder:
                self.train(folder, folds, file)
        return file

    def train(self, folder, left_out, file):
        for number, (data, shapes) in enumerate(self.sets):
            rest = {name: shape for name, shape in shapes.items() if self.folds[name] not in left_out}
            of_set = os.path.join(folder, str(number))
            for name, shape in rest.items():
                os.makedirs(os.path.join(of_set, shape.category), exist_ok=True)
                os.symlink(os.path.abspath(shape.folder), os.path.join(of_set, shape.category, name))
            with open(os.path.join(of_set, "pairs.json"), "w") as text:
                json.dump([pair for pair in pairs_of(data) if pair[1] in rest and pair[2] in rest], text)
        generated = ["--generated", self.generated] if self.generated else []
        sets = [os.path.join(folder, str(number)) for number in range(len(self.sets))]
        subprocess.run([self.program, "roles", "train", *sets, *generated, "--cache", os.path.join(self.out, "cache"),
                        "--threads", "1", "--quiet", "--output", file], check=True)


def stand_ins(row):
    """By part of the raw model, the labelled parts of which it has more of the surface than any other part."""
    result = collections.defaultdict(list)
    for i, line in enumerate(row["common_points"]):
        if max(line) > 0:
            result[row["parts"][line.index(max(line))]].append(row["labelled_parts"][i])
    return result


# What becomes of x, y, z of a model with y up
TURNS = {"z_up": lambda x, y, z: (x, negative(z), y),
         "quarter": lambda x, y, z: (z, y, negative(x)),
         "z_up,quarter": lambda x, y, z: (z, x, y)}


def negative(number):
    return number[1:] if number.startswith("-") else "-" + number


def turned_copy(model, folder, turn):
    """A copy of an OBJ file in a folder, turned; links to what is beside it, such as materials."""
    os.makedirs(folder, exist_ok=True)
    for name in os.listdir(os.path.dirname(model)):
        link = os.path.join(folder, name)
        if not os.path.lexists(link) and name != os.path.basename(model):
            os.symlink(os.path.abspath(os.path.join(os.path.dirname(model), name)), link)
    copy = os.path.join(folder, os.path.basename(model))
    with open(model, errors="replace") as lines, open(copy, "w") as out:
        for line in lines:
            words = line.split()
            if words and words[0] in ("v", "vn"):
                line = " ".join([words[0], *TURNS[turn](*words[1:4])]) + "\n"
            out.write(line)
    return copy


def axes_are_right(result, target):
    """Whether a result says that z is up in the target, and nothing of the source, where y is up."""
    told = [w for w in result["warnings"] if "upright axis was taken" in w]
    return len(told) == 1 and target in told[0] and "taken to be z" in told[0]


def match(program, source, target, file, cache, options):
    if not os.path.exists(file):
        done = subprocess.run([program, "match", source, target, "--json", file, "--quiet", "--threads", "1", "--cache", cache,
                               *options], capture_output=True, text=True)
        if done.returncode:
            print(done.stderr.strip(), file=sys.stderr)
            return None
    with open(file) as text:
        return json.load(text)


def compare(args, models):
    learned = Fold_roles(args) if args.folds else None
    options = args.options.split()
    given = options[options.index("--roles") + 1] if "--roles" in options else "none"
    for data in args.labelled:
        print(f"{os.path.basename(os.path.normpath(data))}:")
        compare_set(args, models, data, lambda *names: learned.without(*names) if learned else given)


def compare_set(args, models, data, roles_for):
    """roles_for: the role model to match shapes with, by their names, or `none`"""
    program = os.path.join(args.build, "shape_correspondence")
    out = os.path.join(args.out, os.path.basename(os.path.normpath(data)))
    shapes = labelled_shapes(data, set(filter(None, args.category.split(","))))
    raw = raw_models_of({name: shape.source for name, shape in shapes.items()}, models)
    pairs = [pair for pair in pairs_of(data) if pair[1] in raw and pair[2] in raw]
    wanted = {(roles_for(name), name) for name in raw}
    wanted |= {(roles_for(source, target), name) for _, source, target in pairs for name in (source, target)}
    rows = {}  # of a role model and a shape; roles tell parts, too
    for roles in sorted({roles for roles, _ in wanted}):
        names = sorted(name for r, name in wanted if r == roles)
        for name, row in part_rows(args, roles, {name: (raw[name], shapes[name].folder) for name in names}).items():
            rows[roles, name] = row
    print_parts({name: rows[roles_for(name), name] for name in sorted(raw) if (roles_for(name), name) in rows})
    pairs = [pair for pair in pairs if all((roles_for(*pair[1:]), name) in rows for name in pair[1:])][:: args.step]
    for kind in ("raw", "carried", "labelled"):
        for category in {pair[0] for pair in pairs}:
            os.makedirs(os.path.join(out, kind, category), exist_ok=True)
    targets = dict(raw)
    if args.turned:
        targets = {name: turned_copy(raw[name], os.path.join(out, "turned", name), "z_up") for name in {pair[2] for pair in pairs}}
    right = matched = without_category = 0
    cache = os.path.join(args.out, "cache")
    for category, source, target in pairs:
        name = os.path.join(category, f"{source}--{target}.json")
        roles = roles_for(source, target)
        options = [*args.options.split(), *(["--roles", roles] if args.folds else [])]
        truth = match(program, *(os.path.join(shapes[s].folder, "parts") for s in (source, target)),
                      os.path.join(out, "labelled", name), cache, ["--up", "y", *options])
        found = match(program, raw[source], targets[target], os.path.join(out, "raw", name), cache,
                      options if args.turned else ["--up", "y", *options])
        if not truth or not found:
            continue
        matched += 1
        right += args.turned and axes_are_right(found, targets[target])
        without_category += "category" in truth and "category" not in found
        here, there = stand_ins(rows[roles, source]), stand_ins(rows[roles, target])
        truth["pairs"] = sorted({(a, b) for p, q in found["pairs"] for a in here[p] for b in there[q]})
        truth.pop("confidences", None)
        with open(os.path.join(out, "carried", name), "w") as file:
            json.dump(truth, file)
    if args.turned:
        print(f"The upright axes of {right} of {matched} raw pairs are found.")
    print(f"Of {without_category} pairs a category is found from labelled parts, but not from raw files.")
    print_matches(*(scores(program, os.path.join(out, kind), data) for kind in ("labelled", "carried")))


def part_rows(args, roles, paths):
    """What benchmark_parts tells, by the name of the shape; `paths` has the raw model and the labelled shape of each."""
    words = [word for raw, labelled in paths.values() for word in (raw, os.path.join(labelled, "parts"))]
    done = subprocess.run([os.path.join(args.build, "benchmark", "Shape_correspondence", "benchmark_parts"),
                           *([] if roles == "none" else ["--roles", roles]), *words], stdout=subprocess.PIPE, text=True)
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    return {os.path.basename(os.path.dirname(row["labelled"])): row for row in rows if row["covered"] > 0.8}


def print_parts(rows):
    if not rows:
        sys.exit("no model is one of a labelled shape")
    print(f"{len(rows)} raw models of labelled shapes: Rand index {mean(r['rand'] for r in rows.values()):.3f}, "
          f"adjusted {mean(r['adjusted_rand'] for r in rows.values()):.3f}, "
          f"F1 of parts {mean(r['f1'] for r in rows.values()):.3f}; "
          f"pieces end at materials in {sum(r['by_materials'] for r in rows.values())}")
    turned = sorted(name for name, row in rows.items() if row["quarter_turns"])
    print(f"{len(turned)} face another side: {', '.join(turned)}")


def mean(numbers):
    numbers = list(numbers)
    return sum(numbers) / len(numbers)


def scores(program, folder, data):
    """F1 of the results in a folder, by category, source and target."""
    done = subprocess.run([program, "evaluate", folder, "--ground-truth", data, "--json", "-", "--quiet"], check=True,
                          stdout=subprocess.PIPE, text=True)
    return {(row["category"], row["source"], row["target"]): row["f1"] for row in json.loads(done.stdout)["results"]}


def print_matches(labelled, raw):
    """Means by category, and the shapes whose pairs lose most."""
    print("|  | pairs | F1 from labelled parts | from raw files |\n|---|---|---|---|")
    for category in [*sorted({pair[0] for pair in raw}), None]:
        pairs = [pair for pair in raw if category in (pair[0], None)]
        print(f"| {category or 'mean of pairs'} | {len(pairs)} | {mean(labelled[pair] for pair in pairs):.3f} | "
              f"{mean(raw[pair] for pair in pairs):.3f} |")
    lost = collections.Counter()
    for pair in raw:
        for shape in pair[1:]:
            lost[shape] += labelled[pair] - raw[pair]
    print("lost most, sums over pairs: " + ", ".join(f"{shape} {loss:.2f}" for shape, loss in lost.most_common(6)), flush=True)


def match_pairs(args, models):
    program = os.path.join(args.build, "shape_correspondence")
    folder = os.path.join(args.out, "pairs")
    with open(args.pairs) as file:
        pairs = [line.split() for line in file if line.strip() and not line.startswith("#")]
    for category, source, target, turn in pairs:
        first, second = (model_of(name, models) for name in (source, target))
        name = "--".join([category, *(n.replace("/", "_") for n in (source, target))])
        second = turned_copy(second, os.path.join(folder, name), turn)
        page = os.path.join(folder, name + ".html")
        done = subprocess.run([program, "match", first, second, "--html", page, "--json", page[:-4] + "json"],
                              capture_output=True, text=True)
        print(f"{name}, {turn}\n{done.stdout}{done.stderr}", flush=True)
        if done.returncode:
            continue
        screenshot("chromium", page, page[:-4] + "png", 1600, 900)


def model_of(name, models):
    """The model of a name, LIBRARY/NAME."""
    library, word = name.split("/")
    found = [m for m in models if library in m.split(os.sep) and os.path.splitext(os.path.basename(m))[0] == word]
    if len(found) != 1:
        sys.exit(f"{len(found)} models are '{name}'")
    return found[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("out")
    parser.add_argument("folders", nargs="*")
    parser.add_argument("--install", action="store_true")
    parser.add_argument("--labelled", action="append", default=[])
    parser.add_argument("--folds", type=int, default=0)
    parser.add_argument("--generated", default="")
    parser.add_argument("--category", default="")
    parser.add_argument("--options", default="")
    parser.add_argument("--turned", action="store_true")
    parser.add_argument("--pairs", default="")
    parser.add_argument("--step", type=int, default=1, help="take every N-th model or pair")
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
    if args.pairs:
        match_pairs(args, models)
    elif args.labelled:
        compare(args, models)
    else:
        survey(args, folders, models)


if __name__ == "__main__":
    main()
