#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills in the figures of the manual's page on the paper from RESULTS.md.

  paper_figures.py RESULTS.md The_paper.txt [--check]

A figure stands behind a comment that names its experiment, shapes, row and column, as in
<!--figure4; generated shapes; no distortion; mean F1-->0.158. With --check nothing is written; exit status 1 if a figure differs.
"""
import argparse
import re
import sys

FIGURE = re.compile(r"<!--([^;>]*);([^;>]*);([^;>]*);([^;>]*)-->([^\s,;:)]*[^\s,;:).])")


def read_tables(text):
    """{(experiment, shapes, row, column): cell} of all tables; the first one counts"""
    cells = {}
    for section in re.split(r"^## ", text, flags=re.MULTILINE)[1:]:
        shapes = section.splitlines()[0].rsplit(": ", 1)[-1]
        command = re.search(r"^`experiments (\w+)", section, flags=re.MULTILINE)
        head = None
        for line in section.splitlines() if command else ():
            row = [cell.strip() for cell in line.strip().strip("|").split("|")]
            if not line.startswith("|"):
                head = None
            elif head is None:
                head = row
            else:
                for column, cell in zip(head[1:], row[1:]):
                    cells.setdefault((command[1], shapes, row[0], column), cell)
    return cells


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results")
    parser.add_argument("page")
    parser.add_argument("--check", action="store_true")
    args = parser.parse_args()
    with open(args.results, encoding="utf-8") as file:
        cells = read_tables(file.read())
    with open(args.page, encoding="utf-8") as file:
        page = file.read()
    failures = []

    def fill(match):
        name, value = tuple(part.strip() for part in match.groups()[:4]), match[5]
        if name not in cells:
            failures.append(f"{'; '.join(name)}: not in {args.results}")
        elif args.check and cells[name] != value:
            failures.append(f"{'; '.join(name)}: {value} in the page, {cells[name]} in {args.results}")
        return match[0][:len(match[0]) - len(value)] + cells.get(name, value)

    filled, count = FIGURE.subn(fill, page)
    unmarked = re.findall(r"(?<!-->)(?<![\d.])0?\.\d{3}\b", re.sub(r"0\.001 of the height", "", filled))
    if args.check and unmarked:
        failures.append(f"{args.page}: figures without a comment that says where they are from: {', '.join(unmarked)}")
    if not args.check and filled != page:
        with open(args.page, "w", encoding="utf-8") as file:
            file.write(filled)
    print(f"{count} figures, {len(failures)} failures", *failures, sep="\n")
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
