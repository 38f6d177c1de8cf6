#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills in the figures of the manual's page on the paper from RESULTS.md.

  paper_figures.py RESULTS.md The_paper.md [--check]

Figures are the numbers with three decimals or more. paper_figures.txt says where each is from, in their order on the page: experiment, shapes, row and column.
With --check nothing is written; exit status 1 if a figure differs.
"""
import argparse
import os
import re
import sys

FIGURE = re.compile(r"(?<![\d.])\d?\.\d{3,}\b")
SOURCES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "paper_figures.txt")


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
    with open(SOURCES, encoding="utf-8") as file:
        names = [tuple(part.strip() for part in line.split(";")) for line in file if not line.startswith("#")]
    count = len(FIGURE.findall(page))
    if count != len(names):
        sys.exit(f"{args.page} has {count} figures, {SOURCES} says of {len(names)} where they are from")
    failures, rest = [], iter(names)

    def fill(match):
        name = next(rest)
        if name not in cells:
            failures.append(f"{'; '.join(name)}: not in {args.results}")
        elif args.check and cells[name] != match[0]:
            failures.append(f"{'; '.join(name)}: {match[0]} in the page, {cells[name]} in {args.results}")
        return cells.get(name, match[0])

    filled = FIGURE.sub(fill, page)
    if not args.check and filled != page:
        with open(args.page, "w", encoding="utf-8") as file:
            file.write(filled)
    print(f"{count} figures, {len(failures)} failures", *failures, sep="\n")
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
