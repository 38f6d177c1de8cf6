#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs all experiments and writes their tables into one file, RESULTS.md, and their figures into the manual's pages on the paper and on accuracy.

  results.py BUILD WORK RESULTS.md [--only peers,table3] [--further NAME=DATA] [--labelled DATA] [--princeton FOLDER]

BUILD is the build folder; WORK keeps the generated shapes, their graphs, tables and pictures. With --further the experiments that
name no shapes, and need no special ones, run on another folder of labelled shapes, too; --labelled names folders that roles are learned
from, and evaluated on by leaving shapes out. A table that WORK has already is not made again; each names the commit that it is of. With --only,
the other tables of RESULTS.md stay as they are.
"""
import argparse
import json
import os
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
EXPERIMENTS = [  # name, pairs of a category at most (0: all), what it is
    ("peers", 45, "All methods side by side, in the same run"),
    ("gallery", 0, "Figures 1 and 9: a gallery, by the paper's method"),
    ("table1", 0, "Table 1: sizes of shapes and times of the search; the pairs of the gallery"),
    ("table2", 0, "Table 2: co-analysis, coarse precision"),
    ("table3", 20, "Table 3: against Xu et al. 2012, and without symmetry"),
    ("alignments", 0, "Flips: the least energy over all alignments, and for the nearest one"),
    ("figure4", 20, "Figure 4: the energy with each term switched off"),
    ("switches", 20, "Switches: the paper's ways of fitting, of proximity and of choosing a direction, and the default's"),
    ("figure10", 8, "Figure 10: energy against k and K, and the proven least energy"),
    ("figure11", 20, "Figure 11: coarse correspondences of the most prominent parts"),
    ("coarse_to_fine", 0, "Coarse to fine: energy and time of the 50 largest pairs over those of the search at once"),
    ("figure13", 0, "Figure 13: through a third shape, by the paper's energy"),
    ("figure14", 0, "Figure 14: medoids by the paper's energy"),
    ("figure15", 0, "Figure 15: ground truth of the gallery"),
    ("figure16", 20, "Figure 16: the most prominent parts"),
    ("figure17", 20, "Figure 17: automatic segmentations of the targets"),
    ("figure18", 15, "Figure 18: uneven segmentations, and shapes damaged in other ways"),
    ("figure19", 8, "Figure 19: quality of the segmentation against energy"),
    ("abstraction", 20, "Methods of part abstraction: deviations from the true curves and sheets, and F1 of matching"),
    ("reliability", 0, "Confidences: how often pairs of a confidence are right"),
]
ROLES = [("sources", "the training sees no shape of either one's source"), ("category", "the training sees nothing of the category")]
ROLES_NOTE = ("The category is not given. Real shapes alone are matched. Beside real ones, the training sees 3000 shapes that a grammar draws (`generate_models --training 3000`); no\n"
              "design follows a labelled shape. The weights of the terms and of confidences are fitted to pairs that share no source with the pair, by roles that were learned\n"
              "without the pair's sources and without generated shapes. Where pairs of other sources of a category gain nothing from roles, geometry alone matches the pair.\n"
              "Geometry is the same method without roles; some of its rules were set on some of these shapes, and others removed by a test on all of them. `stated`: mean\n"
              "confidence; `right`: share of the pairs of parts that are right; `AUC`: probability that a right pair has a higher confidence than a wrong one; `P sure`, `share`:\n"
              "precision of the pairs with a confidence of .7 or more, and their share of all pairs; `error`: mean difference of confidence and share that is right, in ten classes;\n"
              "`front`, `sure front`: with the category given, how often the true front is among those that roles leave possible, and how often it is the only one; `labels`, `with\n"
              "roles`: share of the parts of the second shape that get their label from the first one, by geometry and with roles. Intervals: bootstrap over shapes, of the F1 with\n"
              "roles and of the paired gain over geometry.")
CATEGORY_NOTE = "Columns, weights and intervals are as above. There are no confidences: those of a category that is not known are not fitted to its pairs."
FEW_NOTE = ("F1 of pairs for which the training has only this number of shapes of the category, drawn for every pair without its two shapes, as with\n"
            "`match --examples`; none of them is generated. The category is given. The weights of the terms are those of the other categories with as few\n"
            "examples. `labels`: share of the parts of one shape that get their label from the other one (`collection --labels-from`); even a\n"
            "perfect match does not reach 1, since some labels occur in only one of the shapes.")
CURVE_NOTE = ("F1 if the training sees this number of generated shapes, of ten categories alike, beside the real ones; of its category, a tree sees 40 at most.")
TURNED_NOTE = ("F1 of shapes as they are, and of shapes that are turned about the up axis, each by an angle drawn for the pair: a multiple of 90° (`quarters`)\n"
               "or any. `--front given` takes shapes as they are, `likely` turns those that clearly face another side, `auto` does not prefer the given front.\n"
               "The gain is over geometry on the same shapes; the first row has geometry for shapes that are not turned. The training has no shape of either source.")
ENERGY_NOTE = ("F1 of the correspondences of least energy, by exact search for the given orientation, with roles in the energy; the training has no shape of\n"
               "either source. No weight was chosen: these are all that were tried.")
ROLES_TABLES = [
    ("A few labelled shapes of a category that is not known", "geometry", "examples", FEW_NOTE,
     [(str(n), ["--leave-out", "category", "--told", "--number-of-examples", str(n)]) for n in (1, 3, 5, 8)] +
     [("all of other sources, and generated ones", ["--leave-out", "sources", "--told"])]),
    ("Generated shapes beside the real ones", "geometry", "generated shapes", CURVE_NOTE,
     [(str(n), ["--leave-out", "sources", "--generated-shapes", str(n)]) for n in (0, 90, 300, 1000, 3000)]),
    ("Shapes turned about the up axis", "geometry", "shapes", TURNED_NOTE,
     [("as they are, `--front given`", ["--front", "given", "--leave-out", "sources"]), ("as they are, `--front likely`", ["--front", "likely", "--leave-out", "sources"]),
      ("as they are, category left out, `given`", ["--front", "given", "--leave-out", "category"]),
      ("as they are, category left out, `likely`", ["--front", "likely", "--leave-out", "category"]),
      ("quarters, `given`", ["--turned", "quarters", "--front", "given", "--leave-out", "sources"]),
      ("quarters, `likely`", ["--turned", "quarters", "--front", "likely", "--leave-out", "sources"]),
      ("quarters, `auto`", ["--turned", "quarters", "--front", "auto", "--leave-out", "sources"]), ("any, `auto`", ["--turned", "any", "--front", "auto", "--leave-out", "sources"]),
      ("any, `auto`, the category given", ["--turned", "any", "--front", "auto", "--told", "--leave-out", "sources"])]),
    ("Roles in the energy", "least energy", "weight of roles", ENERGY_NOTE,
     [(weight, ["--leave-out", "sources", "--role-weight", weight]) for weight in ("0.1", "0.3", "1", "3")]),
]
FIGURE12 = "Figure 12: blends"
FIGURE12_NOTE = ("The four blends of the manual's gallery. The worst of 25 frames: share of the parts due to stand on the ground that do not, and increase of the gaps\n"
                 "that it takes to join all parts, as a share of the height.")
PARTS_TITLE = "Parts that are found, the training sees no shape of the same source"
PARTS_NOTE = ("Meshes of labelled shapes as one object, or as three of parts with like roles. recovered: share of the parts of which something that is found has .75 or more\n"
              "of the union of both in common; IoU: mean over the parts of the greatest such share; ratio: found over true parts; pure: share of what is found that lies to\n"
              "90 % in one part; F1 of the parts. Best cut: the one of the tree that recovers most parts.")
PRINCETON_NOTE = ("Label transfer: share of the area that gets its label from 1, 3 or 12 examples of the category, for segments as the labels give them (`given`) and for\n"
                  "those of `segment_mesh()` (`raw`); a mesh that is refused counts as 0. Examples have given segments. The upright axis is estimated for each mesh, as every\n"
                  "command does. Rand error: share of the pairs of faces that only one of two segmentations has in one segment, here of `segment_mesh()` and of the connected\n"
                  "faces of one label. Nothing was fitted to or chosen on this benchmark.")
WITH_GALLERY = "gallery", "table1", "figure15"  # experiments that show boats and carts, too
# Experiments that name shapes, or need large categories, closed surfaces or damaged shapes
GENERATED_ONLY = ("gallery", "table1", "figure15", "figure17", "figure18", "figure19")


def generate(generator, folder, *options, shapes=("--benchmark",)):
    if not os.path.isdir(folder):
        subprocess.run([generator, *shapes, *options, folder], check=True)
    return folder


def table(args, programs, data, further_data, name, pairs, out):
    path = os.path.join(out, name + ".md")
    if not os.path.exists(path):
        command = [os.path.join(programs, "experiments"), name, data, *further_data, "--out", out, "--cache",
                   os.path.join(args.work, "cache")] + (["--pairs", str(pairs)] if pairs else [])
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
        with open(path, "w") as file:
            file.write(f"{done.stdout.strip()}\n\nCommit {commit()}.\n")
    with open(path) as file:
        return file.read().strip()


def commit():
    """The commit that is measured, `-dirty` if more than the results has changed since."""
    git = lambda *words: subprocess.run(["git", "-C", HERE, *words], stdout=subprocess.PIPE, text=True, check=True).stdout.strip()
    written = "RESULTS.md", "The_paper.md", "Accuracy.md"
    changed = [file for file in git("diff", "--name-only", "HEAD").splitlines() if os.path.basename(file) not in written]
    return git("rev-parse", "--short", "HEAD") + "-dirty" * bool(changed)


def figure12(args, out, folders):
    with open(os.path.join(HERE, "figure12_pairs.txt")) as file:
        pairs = [line.split() for line in file if line.strip() and not line.startswith("#")]
    lines = ["| blend | schedule | support | apart |", "|---|---|---|---|"]
    for category, *names in pairs:
        models = [next(path for path in (os.path.join(folder, category, name, "parts") for folder in folders) if os.path.isdir(path)) for name in names]
        result = os.path.join(out, "figure12.json")
        subprocess.run([os.path.join(args.build, "shape_correspondence"), "blend", *models, "-o", os.path.join(out, "figure12"), "--frames", "25", "--json", result,
                        "--quiet", "--cache", os.path.join(args.work, "cache")], check=True)
        with open(result) as file:
            blend = json.load(file)
        worst = [max(frame["quality"][measure] for frame in blend["frames"]) for measure in ("support", "apart")]
        lines.append(f"| {' → '.join(names)} | {blend['schedules'][0]['name']} | {worst[0]:.3f} | {worst[1]:.3f} |")
    table = "\n".join(lines)
    return f"## {FIGURE12}: generated shapes\n\n`blend SOURCE TARGET --frames 25 --json FILE`\n\n{FIGURE12_NOTE}\n\n{table}\n\nCommit {commit()}.\n"


def with_kept(sections, path):
    """The sections of a file of results, those of the same headings replaced by new ones, in the order of the experiments."""
    with open(path) as file:
        kept = ["## " + text for text in file.read().split("\n## ")[1:]]
    heading = lambda section: section.split("\n", 1)[0]
    by_heading = {heading(section): section for section in kept + sections}
    titles = [title for _, _, title in EXPERIMENTS]
    titles.insert(titles.index(next(title for title in titles if title.startswith("Figure 13"))), FIGURE12)

    def place(text):
        title = [i for i, title in enumerate(titles) if text.startswith(f"## {title}: ")] or [len(titles)]
        return title[-1], not text.endswith("generated shapes")
    return [by_heading[text] for text in sorted(by_heading, key=place)]


def roles_evaluation(args, generated, name, options, out):
    """The table that `validate_roles` prints, and its JSON."""
    base = os.path.join(out, f"roles_{name}")
    if not os.path.exists(base + ".json"):
        command = [os.path.join(args.build, "benchmark", "Shape_correspondence", "validate_roles"), *args.labelled, "--generated", generated,
                   "--json", base + ".json", *options, "--cache", os.path.join(args.work, "cache")]
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
        with open(base + ".txt", "w") as file:
            file.write(done.stdout)
    with open(base + ".txt") as text, open(base + ".json") as document:
        return text.read().rstrip(), json.load(document)["categories"]


def roles_rows(first, title, evaluations):
    """A table with one row for each evaluation: F1 by category, and the paired gain over the first row, named `first`."""
    names = [entry["category"] for entry in evaluations[0][1]]
    has_labels = first == "geometry"  # labels are transferred by parts
    ends = ["gain", "95 %"] + ["labels"] * has_labels
    lines = [f"| {title} | " + " | ".join(names + ends) + " |", "|---" * (1 + len(names + ends)) + "|"]
    f1 = lambda entry, method: f"{entry[method]['f1']['mean']:.3f}"
    row = lambda name, cells: lines.append(f"| {name} | " + " | ".join(cells) + " |")
    reference = evaluations[0][1]
    row(first, [f1(entry, "geometry") for entry in reference] + ["", ""] + [f"{reference[-1]['labels']:.3f}"] * has_labels)
    for name, entries in evaluations:
        gain = entries[-1]["gain"]["f1"]
        row(name, [f1(entry, "with_roles") for entry in entries] +
            [f"{gain['mean']:+.3f}", f"{gain['low']:+.3f} to {gain['high']:+.3f}"] + [f"{entries[-1]['labels_with_roles']:.3f}"] * has_labels)
    return "\n".join(lines)


def roles_sections(args, generated, out):
    for left_out, title in ROLES:
        text, _ = roles_evaluation(args, generated, left_out, ["--leave-out", left_out], out)
        note = ROLES_NOTE if left_out == ROLES[0][0] else CATEGORY_NOTE
        table = "\n".join("    " + line.rstrip() for line in text.splitlines())
        yield (f"## Matching with roles, {title}\n\n`validate_roles LABELLED... --generated training "
               f"--leave-out {left_out}`\n\n{note}\n\n{table}\n")
    for title, first, head, note, rows in ROLES_TABLES:
        evaluations = [(name, roles_evaluation(args, generated, "_".join(options).replace("-", ""), options, out)[1])
                       for name, options in rows]
        commands = "\n".join(f"`validate_roles LABELLED... --generated training {' '.join(options)}`" for _, options in rows)
        yield f"## {title}\n\n{commands}\n\n{note}\n\n{roles_rows(first, head, evaluations)}\n"


def parts_section(args, out):
    """How well the parts of shapes are found by models that were learned without the sources of these shapes."""
    path = os.path.join(out, "parts.txt")
    if not os.path.exists(path):
        command = [os.path.join(args.build, "benchmark", "Shape_correspondence", "train_parts"), "--folds", *args.labelled]
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
        with open(path, "w") as file:
            file.write(done.stdout)
    with open(path) as file:
        table = "\n".join("    " + line.rstrip() for line in file if "to learn from" not in line)
    return f"## {PARTS_TITLE}\n\n`train_parts --folds LABELLED...`\n\n{PARTS_NOTE}\n{table}\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("work")
    parser.add_argument("results")
    parser.add_argument("--only", default="")
    parser.add_argument("--ways", default="segmentation,open,gaps,noise,scale,rotation", help="ways of damaging shapes, in Figure 18")
    parser.add_argument("--further", action="append", default=[])
    parser.add_argument("--labelled", action="append", default=[])
    parser.add_argument("--princeton", help="folder of the Princeton Segmentation Benchmark, as psb.py takes it")
    args = parser.parse_args()
    programs = os.path.join(args.build, "benchmark", "Shape_correspondence")
    generator = os.path.join(programs, "generate_models")
    ways = {"figure18": args.ways.split(","), "figure19": ["segmentation"]}
    only = set(filter(None, args.only.split(",")))
    os.makedirs(args.work, exist_ok=True)
    sets = [("generated shapes", generate(generator, os.path.join(args.work, "benchmark")))]
    sets += [tuple(further.split("=", 1)) for further in args.further]

    gallery = generate(generator, os.path.join(args.work, "gallery"), shapes=("--gallery",))
    training = generate(generator, os.path.join(args.work, "training"), shapes=("--training", "3000"))

    sections = []
    for name, pairs, title in EXPERIMENTS:
        if only and name not in only:
            continue
        for set_name, data in sets:
            if set_name != "generated shapes" and name in GENERATED_ONLY:
                continue
            worse = [generate(generator, os.path.join(args.work, way), "--degrade", way) for way in ways.get(name, ())]
            if name in WITH_GALLERY:
                worse = [gallery]
            out = os.path.join(args.work, "out", set_name.replace(" ", "_"))
            os.makedirs(out, exist_ok=True)
            text = table(args, programs, data, worse, name, pairs, out)
            words = ["experiments", name, "DATA", *map(os.path.basename, worse)] + (["--pairs", str(pairs)] if pairs else [])
            sections.append(f"## {title}: {set_name}\n\n`{' '.join(words)}`\n\n{text}\n")
            print(name, set_name, flush=True)
    if not only or "figure12" in only:
        sections.append(figure12(args, os.path.join(args.work, "out"), [sets[0][1], gallery]))
    if args.labelled and (not only or "roles" in only):
        out = os.path.join(args.work, "out")
        os.makedirs(out, exist_ok=True)
        sections += roles_sections(args, training, out)
    if args.labelled and (not only or "parts" in only):
        sections.append(parts_section(args, os.path.join(args.work, "out")))
    if args.princeton and (not only or "princeton" in only):
        command = [os.path.join(os.path.dirname(os.path.abspath(__file__)), "psb.py"), args.princeton, "--cache", os.path.join(args.work, "cache")]
        environment = {**os.environ, "PYTHONPATH": os.path.join(args.build, "python")}
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True, check=True)
        sections.append(f"## Princeton Segmentation Benchmark\n\n`psb.py FOLDER`\n\n{PRINCETON_NOTE}\n\n{done.stdout}")
    if only and os.path.exists(args.results):
        sections = with_kept(sections, args.results)
    with open(args.results, "w") as file:
        file.write("# Results of the experiments\n\n"
                   "Made by `results.py`, which runs every command that is named below. P, R, F1: precision, recall and F1 of pairs of parts,\n"
                   "means over the pairs of a category, then over categories; the interval of the mean F1 is from a bootstrap over shapes. Constants of the methods\n"
                   "were set on the development set, those of the default also on generated shapes that were designed one by one. The present generated shapes\n"
                   "are drawn by a grammar, and no constant was chosen on them. A section on generated shapes that has no names such as `chair_7` is older.\n"
                   "Halves are by source family. Times are wall-clock times on two cores that had other work: compare them within a table\n"
                   "only; the manual's page on performance has times of an idle machine. The manual's page on accuracy says what was tried. A table that names\n"
                   "no commit is older than those that do: there, the paper's method is what the row `all three` of the table of switches is now.\n\n" + "\n".join(sections))
    for script, page in (("paper_figures.py", "The_paper.md"), ("accuracy_page.py", "Accuracy.md")):
        page = os.path.join(HERE, "..", "..", "doc", "Shape_correspondence", page)
        subprocess.run([os.path.join(HERE, script), args.results, page], check=True)


if __name__ == "__main__":
    main()
