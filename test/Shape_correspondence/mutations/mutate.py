#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Changes the sources, one mistake at a time, and sees whether a test fails.

mutations.txt lists the mistakes. Each is made in a copy of the checkout; the test program that is named beside it is
built and run there. It must fail in the named test case, or the mutation survives."""

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
TIME_LIMIT = 300  # seconds; a changed program may run forever


class Mutation:
    def __init__(self, block):
        """A block of mutations.txt: what the mistake is, the file, lines out (-), lines in (+), the test that fails (!)"""
        lines = block.splitlines()
        self.what, self.file = lines[0], lines[1]
        pick = lambda sign: [line[2:] for line in lines[2:] if line.startswith(sign)]
        self.old, self.new = "\n".join(pick("-")), "\n".join(pick("+"))
        self.test, self.case = pick("!")[0].split(": ", 1)

    def changed(self, text):
        if text.count(self.old) != 1:
            raise ValueError(f"{self.what}: its text occurs {text.count(self.old)} times in {self.file}")
        return text.replace(self.old, self.new)

    def check(self):
        """Raises ValueError unless it can be made in the checkout and its test exists"""
        self.changed((CHECKOUT / self.file).read_text())
        source = TESTS / f"{self.test}.cpp"
        if not source.exists() or f'TEST_CASE("{self.case}")' not in source.read_text():
            raise ValueError(f"{self.what}: there is no test case '{self.case}' in {self.test}.cpp")


def read_mutations():
    blocks = [b for b in re.split(r"\n\s*\n", LIST.read_text().strip()) if not b.startswith("#")]
    return [Mutation(block) for block in blocks]


class Scratch:
    """A copy of the checkout with a build folder of its own"""

    def __init__(self, folder, jobs):
        self.folder, self.build, self.jobs = folder, folder / "build", jobs
        self.copy_checkout()
        self.run("cmake", "-S", folder, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                 "-DSHAPE_CORRESPONDENCE_EXAMPLES=OFF")

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
        for target in list(self.folder.rglob("*")):
            name = target.relative_to(self.folder)
            if target.is_file() and name.parts[0] != "build" and name not in names:
                target.unlink()

    def run(self, *command):
        result = subprocess.run([str(c) for c in command], capture_output=True, text=True)
        if result.returncode:
            raise RuntimeError(result.stdout[-3000:] + result.stderr[-3000:])

    def failing_cases(self, test):
        """The names of the test cases that fail"""
        self.run("cmake", "--build", self.build, "--target", test, "-j", self.jobs)
        try:
            program = self.build / "test" / TESTS.name / test
            report = subprocess.run([program, "-r", "xml"], capture_output=True, text=True, timeout=TIME_LIMIT).stdout
        except subprocess.TimeoutExpired:
            return ["(no end)"]
        # A program that crashed has not closed its report; the last test case in it is the one
        names = []
        for block in report.split("<TestCase ")[1:]:
            if '<OverallResult success="true"' not in block:
                names.append(html.unescape(re.match('name="([^"]*)"', block)[1]))
        return names

    def try_mutation(self, mutation):
        """The names of the test cases that notice it"""
        file = self.folder / mutation.file
        original = file.read_text()
        file.write_text(mutation.changed(original))
        try:
            return self.failing_cases(mutation.test)
        finally:
            file.write_text(original)


def table_text(rows):
    lines = ["# What the tests notice", "",
             "Made by `mutate --table`: the mistakes of `mutations.txt`, each made alone, and the test case that fails.", "",
             "| file | mistake | test that fails |", "|---|---|---|"]
    for mutation in rows:
        lines.append(f"| `{mutation.file}` | {mutation.what} | `{mutation.test}`: {mutation.case} |")
    return "\n".join(lines).replace("_", "\\_") + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", help="only mutations that have one of these words in their line or file")
    parser.add_argument("--check", action="store_true",
                        help="only check that every mutation can be made and that its test exists; builds nothing")
    parser.add_argument("--table", action="store_true", help=f"write {TABLE.name} when all were noticed")
    parser.add_argument("--scratch", type=Path, default=CHECKOUT / "build" / "mutations",
                        help="folder of the copy, kept for the next time (default: %(default)s)")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count(), help="compilers at a time (default: %(default)s)")
    arguments = parser.parse_args()

    mutations = read_mutations()
    errors = 0
    for mutation in mutations:
        try:
            mutation.check()
        except ValueError as error:
            errors += 1
            print(error, file=sys.stderr)
    if errors or arguments.check:
        print(f"{len(mutations)} mutations, {errors} that cannot be made or have no test")
        return 1 if errors else 0

    chosen = [m for m in mutations if not arguments.words or any(w in m.what + m.file for w in arguments.words)]
    scratch = Scratch(arguments.scratch.resolve(), arguments.jobs)
    for test in sorted({mutation.test for mutation in chosen}):
        failing = scratch.failing_cases(test)
        print(f"unchanged, {test}: " + (f"FAILS: {failing}" if failing else "passes"), flush=True)
        errors += bool(failing)
    if errors:
        return 1
    survivors = 0
    for i, mutation in enumerate(chosen, 1):
        try:
            failing = scratch.try_mutation(mutation)
        except RuntimeError as error:
            failing, message = [], f"does not compile\n{error}"
        else:
            message = "SURVIVES" + (f", though this fails: {', '.join(failing)}" if failing else "")
        noticed = mutation.case in failing
        survivors += not noticed
        print(f"{i}/{len(chosen)} {mutation.file}: {mutation.what}: " +
              (f"fails {mutation.test}: {', '.join(failing)}" if noticed else message), flush=True)
    print(f"{len(chosen) - survivors} of {len(chosen)} mutations noticed")
    if arguments.table and not survivors and chosen == mutations:
        TABLE.write_text(table_text(chosen))
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
