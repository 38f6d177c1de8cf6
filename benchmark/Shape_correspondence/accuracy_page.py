#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the page of the manual on accuracy from the results of the experiments.

  accuracy_page.py RESULTS.md Accuracy.txt [--check]

All numbers are those of RESULTS.md, which results.py writes. With --check, nothing is written, and the status is 1 if the page is not
what it would write.
"""
import argparse
import re
import sys

PAGE = """/*!
\\page sc_accuracy Accuracy

This page is written by `accuracy_page.py` from `benchmark/Shape_correspondence/RESULTS.md`, which `results.py` writes. P, R and F1 are precision, recall
and F1 of pairs of parts against human or generated labels (\\ref sc_evaluation): means over the pairs of a category, then over categories. The intervals
are 95 % bootstrap intervals over shapes.

Three sets of shapes are used. Only the second one is a blind test of the default method:

- *generated shapes*: ninety shapes of six categories, `generate_models --benchmark`. Some constants and rules of the default method were chosen on them.
- *shapes of random styles*: `generate_models --benchmark --random-styles --seed 101`. Nothing was chosen on them, but they are made of the same
  components as the generated shapes.
- *development set*: real shapes of six categories, labelled by hand, which are not part of the package. Constants of all methods were set on it.

\\section sc_ac_methods Methods

Without roles. The other methods are reimplementations from their papers; RESULTS.md lists what is simplified. Seconds are for one pair of abstracted
shapes.

{methods}
\\section sc_ac_roles Roles

Cross-validated on labelled shapes: the model was trained without the shapes that the column *left out* names. *sure* is the precision of pairs with a
confidence of .7 or more, and *share* their share of all pairs.

{roles}
So roles help for categories that they were learned from, but not for others. A few labelled shapes of a category that is left out (`--examples`), with the
category given, help again; *labels* is the share of the parts of one shape that get their label from another one by `collection --labels-from`:

{few}
With roles in the energy (`--role-weight`), exact search gives for pairs of shapes that were left out of the training:

{energy}
\\section sc_ac_confidence Confidences

Pairs by confidence, and the share of them that is right. Without roles.

{confidence}
\\cgalFigureBegin{{sc_reliability,reliability.svg}}
Confidence of pairs and share of right pairs, on the generated shapes (`experiments reliability FOLDER`).
\\cgalFigureEnd

\\section sc_ac_abstraction Abstraction

Generated shapes have a known curve or sheet for every part. Deviations are fractions of the diagonal of the part; seconds are processor time.

{abstraction}
\\section sc_ac_search Search

The beam search of the paper against the proven minimum, for pairs of the gallery (Table 1 of the paper): numbers of parts and symmetry groups of source and target, and
seconds.

{search}
\\cgalFigureBegin{{sc_figure10,figure10.svg}}
Mean energy of the beam search relative to the proven minimum, by beam width (`experiments figure10 FOLDER`).
\\cgalFigureEnd
*/
"""
SETS = [("generated shapes", "generated"), ("shapes of random styles", "random styles"), ("development set", "development")]


class Results:
    def __init__(self, text):
        self.sections = {}
        for section in re.split(r"^## ", text, flags=re.M)[1:]:
            title, _, body = section.partition("\n")
            self.sections[title] = body

    def section(self, title):
        if title not in self.sections:
            sys.exit(f"accuracy_page.py: RESULTS.md has no section '{title}'")
        return self.sections[title]

    def rows(self, title):
        """The table of a section: by row, column to text."""
        lines = [[cell.strip() for cell in line.strip("|").split("|")]
                 for line in self.section(title).splitlines() if line.startswith("|")]
        return [dict(zip(lines[0], line)) for line in lines[2:]]

    def last_line(self, title, first_word):
        return [line.split() for line in self.section(title).splitlines() if line.split()[:1] == [first_word]][-1]


def table(heads, rows):
    lines = [heads, ["---"] * len(heads), *rows]
    return "".join("| " + " | ".join(row) + " |\n" for row in lines)


def methods(results):
    text = ""
    for title, name in SETS:
        rows = results.rows("All methods side by side, in the same run: " + title)
        text += f"{title.capitalize()}:\n\n" + table(
            ["method", "P", "R", "F1", "95 %", "seconds"],
            [[row["method"], row["mean P"], row["mean R"], row["mean F1"], row["95 %"], row["s / pair"]] for row in rows]) + "\n"
    return text


def roles(results):
    rows = []
    for title, left_out in (("the training sees neither shape of a pair", "both shapes"),
                            ("the training sees no shape of either one's source", "all shapes of their sources"),
                            ("the training sees nothing of the category", "the category")):
        words = results.last_line("Matching with roles, " + title, "mean")
        _, pairs, _, _, geometry, p, r, f1, _, gain, interval, _, _, _, sure, share = words[:16]
        rows.append([left_out, pairs, geometry, p, r, f1, gain, interval.replace("..", " to "), sure, share])
    return table(["left out", "pairs", "F1 without roles", "P", "R", "F1 with roles", "gain", "95 %", "sure", "share"], rows)


def of_means(results, title, head):
    rows = results.rows(title)
    heads = [key for key in (head, "mean", "gain", "95 %", "labels") if key in rows[0]]
    return table(["F1" if key == "mean" else key for key in heads], [[row[key] for key in heads] for row in rows])


def confidence(results):
    rows = []
    for title, name in SETS:
        for row in results.rows("Confidences: how often pairs of a confidence are right: " + title):
            rows.append([name, row["confidence"], row["pairs"], row["right"]])
    return table(["shapes", "mean confidence", "pairs", "right"], rows)


def abstraction(results):
    title = ("Methods of part abstraction: deviations from the true curves and sheets, and F1 of matching: "
             "generated shapes")
    rows = results.rows(title)
    is_old = "\nCommit " not in results.section(title)
    note = "\nThis table is older than the other figures of the flow in this manual.\n" if is_old else ""
    heads = ["abstraction", "kinds as stated", "curves off by, median", "sheets off by, median", "F1 paper", "F1 default",
             "CPU s / shape"]
    return table(["abstraction", "right kinds", "curves, median", "sheets, median", "F1 of the paper's method", "F1 default",
                  "seconds per shape"], [[row[head] for head in heads] for row in rows]) + note


def search(results):
    rows = results.rows("Table 1: sizes of shapes and times of the search; the pairs of the gallery: generated shapes")
    heads = ["pair", "#P_s", "#P_t", "#G_s", "#G_t", "beam s", "exact s", "parts s"]
    return table(["pair", "parts", "parts", "groups", "groups", "beam", "exact", "default"],
                 [[row[head] for head in heads] for row in rows])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results")
    parser.add_argument("page")
    parser.add_argument("--check", action="store_true")
    args = parser.parse_args()
    with open(args.results) as file:
        results = Results(file.read())
    text = PAGE.format(methods=methods(results), roles=roles(results),
                       few=of_means(results, "A few labelled shapes of a category that is not known", "examples"),
                       energy=of_means(results, "Roles in the energy", "weight of roles"), confidence=confidence(results),
                       abstraction=abstraction(results), search=search(results))
    if not args.check:
        with open(args.page, "w") as file:
            file.write(text)
        return
    with open(args.page) as file:
        if file.read() != text:
            sys.exit(f"{args.page} is not of these results; write it anew: accuracy_page.py {args.results} {args.page}")


if __name__ == "__main__":
    main()
