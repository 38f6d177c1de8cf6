#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which pairs of parts a blend would morph at each value of --min-confidence, of shapes that the role model has not seen:

  validate_roles LABELLED_FOLDER... --json EVALUATION
  blend_confidence.py EVALUATION

Prints a table as Markdown. Kept: the share of the pairs that are right, and of those that are wrong, which still morph. F1: of
precision and the share of right pairs that are kept. Balance: right minus wrong pairs that morph, in pairs found, which is greatest
where a wrong morph is as bad as a right pair that shrinks and grows instead. Both by labels, and by coarse labels alone. Below it: the
value of the best balance on the other categories, and the balance that it has on the category itself, against the first value.
Every pair of shapes of a category weighs the same, and every category.
"""
import argparse
import collections
import json
import statistics

THRESHOLDS = [0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.7, 0.8]


def shares(pair, threshold, judgement):
    """Of the pairs of parts found: right and kept, wrong and kept."""
    kept = [part[judgement] for part in pair["confidences"] if part[0] >= threshold]
    found = len(pair["confidences"])
    return sum(kept) / found, (len(kept) - sum(kept)) / found


def by_category(pairs, threshold, judgement):
    rows = collections.defaultdict(list)
    for pair in pairs:
        if pair["confidences"]:
            rows[pair["category"]].append(shares(pair, threshold, judgement))
    return {category: [statistics.mean(column) for column in zip(*of)] for category, of in rows.items()}


def mean(of_categories):
    return [statistics.mean(column) for column in zip(*of_categories.values())]


def columns(pairs, threshold, judgement):
    right, wrong = mean(by_category(pairs, threshold, judgement))
    all_right, all_wrong = mean(by_category(pairs, 0, judgement))
    return [right / all_right, wrong / all_wrong, 2 * right / (right + wrong + all_right), right - wrong]


def left_out(pairs, judgement):
    """The mean balance of the first threshold, and that of the threshold chosen on the other categories."""
    balance = {t: {c: right - wrong for c, (right, wrong) in by_category(pairs, t, judgement).items()} for t in THRESHOLDS}
    categories = list(balance[THRESHOLDS[0]])
    chosen = {c: max(THRESHOLDS, key=lambda t: sum(balance[t][other] for other in categories if other != c)) for c in categories}
    return (statistics.mean(balance[THRESHOLDS[0]].values()), statistics.mean(balance[chosen[c]][c] for c in categories),
            sorted(set(chosen.values())))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("evaluation")
    with open(parser.parse_args().evaluation, encoding="utf-8") as file:
        pairs = json.load(file)["pairs"]
    print("| least confidence | right kept | wrong kept | F1 | balance | equal roles kept | others kept | F1 | balance |")
    print("|" + "---|" * 9)
    for threshold in THRESHOLDS:
        values = columns(pairs, threshold, 1) + columns(pairs, threshold, 2)
        print(f"| {threshold:g} | " + " | ".join(f"{value:.3f}" for value in values) + " |")
    print()
    for judgement, name in ((1, "labels"), (2, "coarse labels")):
        first, chosen, values = left_out(pairs, judgement)
        print(f"By {name}, balance {first:.3f} with {THRESHOLDS[0]:g} and {chosen:.3f} with the best of the other categories, "
              + " or ".join(f"{value:g}" for value in values) + ".")


if __name__ == "__main__":
    main()
