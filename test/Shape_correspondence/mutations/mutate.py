#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the mistakes of mutations.txt, one at a time, and sees whether the tests notice.

Each is made in a copy of the checkout, in which the test program that is named beside it is built and run. The named
test case must fail; else the mistake survives, and the exit status is 1. The first time, the library is built in the
copy."""

import argparse
import html
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
TESTS = HERE.parent
CHECKOUT = TESTS.parent.parent
LIST, TABLE = HERE / "mutations.txt", HERE / "README.md"
TIME_LIMIT = 300  # seconds for a test program; one with a mistake may not end


class Mutation:
    def __init__(self, block):
        """A block of mutations.txt, whose first lines say what it is"""
        lines = block.splitlines()
        self.what, self.file = lines[:2]
        marked = {mark: [line[2:] for line in lines[2:] if line[0] == mark] for mark in "-+!"}
        self.old, self.new = "\n".join(marked["-"]), "\n".join(marked["+"])
        self.test, self.case = marked["!"][0].split(": ", 1)

    def made_in(self, text):
        if text.count(self.old) != 1:
            raise ValueError(f"{self.what}: what it replaces occurs {text.count(self.old)} times in {self.file}")
        return text.replace(self.old, self.new)

    def check(self):
        """Raises ValueError unless it can be made in the checkout and its test case exists"""
        self.made_in((CHECKOUT / self.file).read_text())
        source = TESTS / f"{self.test}.cpp"
        if not source.exists() or f'TEST_CASE("{self.case}")' not in source.read_text():
            raise ValueError(f"{self.what}: there is no test case '{self.case}' in {self.test}.cpp")


def read_mutations():
    text = re.sub("^#.*\n", "", LIST.read_text(), flags=re.MULTILINE)
    return [Mutation(block) for block in re.split(r"\n\s*\n", text.strip())]


class Scratch:
    """A copy of the checkout with a build folder of its own"""

    def __init__(self, folder, jobs):
        self.folder, self.build, self.jobs = folder, folder / "build", jobs
        self.copy_checkout()
        self.run("cmake", "-S", folder, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                 "-DSHAPE_CORRESPONDENCE_EXAMPLES=OFF", "-DSHAPE_CORRESPONDENCE_UNITY_BUILD=OFF")

    def copy_checkout(self):
        """Copies what differs, so that what was built stays valid, and removes what the checkout does not have"""
        listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=CHECKOUT,
                                capture_output=True, text=True, check=True).stdout
        names = {Path(name) for name in listed.split("\0") if name and (CHECKOUT / name).is_file()}
        for name in names:
            source, target = CHECKOUT / name, self.folder / name
            if not target.exists() or target.read_bytes() != source.read_bytes():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(source, target)
        for top in self.folder.iterdir():
            for target in [top, *top.rglob("*")] if top != self.build else []:
                if target.is_file() and target.relative_to(self.folder) not in names:
                    target.unlink()

    def run(self, *command):
        result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        if result.returncode:
            raise RuntimeError(result.stdout[-3000:] + result.stderr[-3000:])

    def failing_cases(self, test):
        """The names of the test cases of a program that fail"""
        self.run("cmake", "--build", self.build, "--target", test, "-j", self.jobs)
        try:
            report = subprocess.run([self.build / "test" / TESTS.name / test, "-r", "xml"], capture_output=True,
                                    text=True, timeout=TIME_LIMIT).stdout
        except subprocess.TimeoutExpired as timeout:
            report = (timeout.stdout or b"").decode()
        # The last test case of a report that is cut off is the one that crashed or did not end
        return [html.unescape(re.match('name="([^"]*)"', case)[1]) for case in report.split("<TestCase ")[1:]
                if '<OverallResult success="true"' not in case]

    def cases_noticing(self, mutation):
        file = self.folder / mutation.file
        original = file.read_text()
        file.write_text(mutation.made_in(original))
        try:
            return self.failing_cases(mutation.test)
        finally:
            file.write_text(original)


def table_text(mutations):
    lines = ["# Mistakes that the tests detect", "",
             "The mistakes of `mutations.txt`, each made alone, and a test case that failed; `mutate.py --table` writes this table.",
             "", "| file | mistake | test case |", "|---|---|---|"]
    lines += [f"| `{m.file}` | {m.what} | `{m.test}`: {m.case} |" for m in mutations]
    return "\n".join(lines) + "\n"


def number_of_bad_entries(mutations):
    bad = 0
    for mutation in mutations:
        try:
            mutation.check()
        except ValueError as error:
            bad += 1
            print(error, file=sys.stderr)
    print(f"{len(mutations)} mistakes in {LIST.name}, {bad} that cannot be made or have no test")
    return bad


def number_of_failing_programs(scratch, mutations):
    """Tests have to pass without any mistake"""
    failing = 0
    for test in sorted({mutation.test for mutation in mutations}):
        cases = scratch.failing_cases(test)
        failing += bool(cases)
        print(f"{test} without mistakes: " + ("fails: " + ", ".join(cases) if cases else "passes"), flush=True)
    return failing


def number_of_survivors(scratch, mutations):
    survivors = 0
    for i, mutation in enumerate(mutations, 1):
        print(f"{i}/{len(mutations)} {mutation.file}: {mutation.what}: ", end="", flush=True)
        try:
            cases = scratch.cases_noticing(mutation)
        except RuntimeError as error:
            cases = []
            print(f"DOES NOT COMPILE\n{error}", flush=True)
        else:
            print(("noticed: " if mutation.case in cases else "SURVIVES; ") + (", ".join(cases) or "nothing fails"),
                  flush=True)
        survivors += mutation.case not in cases
    print(f"{len(mutations) - survivors} of {len(mutations)} mistakes noticed")
    return survivors


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", help="only mistakes that say one of these, or whose files do")
    parser.add_argument("--check", action="store_true",
                        help="only see whether every mistake can be made and its test case exists; builds nothing")
    parser.add_argument("--table", action="store_true", help=f"write {TABLE.name} if all mistakes are noticed")
    parser.add_argument("--scratch", type=Path, default=CHECKOUT / "build" / "mutations",
                        help="folder of the copy, kept for the next time (default: %(default)s)")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count(),
                        help="compilers at a time (default: %(default)s)")
    arguments = parser.parse_args()

    mutations = read_mutations()
    if number_of_bad_entries(mutations):
        return 1
    if arguments.check:
        return 0
    chosen = [m for m in mutations if not arguments.words or any(w in m.what or w in m.file for w in arguments.words)]
    scratch = Scratch(arguments.scratch.resolve(), arguments.jobs)
    if number_of_failing_programs(scratch, chosen) or number_of_survivors(scratch, chosen):
        return 1
    if arguments.table and chosen == mutations:
        TABLE.write_text(table_text(chosen))
    return 0


if __name__ == "__main__":
    sys.exit(main())
