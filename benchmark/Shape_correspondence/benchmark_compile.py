#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
#
# This file is part of the CGAL package Shape_correspondence.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What it costs a user to compile: the median of the CPU seconds and of the peak memory of a program that includes the
whole package and calls find_correspondence(), and, with --headers, of every public header alone.

The compiler is $CXX or g++, without ccache. --limit makes the exit status 1 where the program exceeds 3 s or 450 MB,
what the package promises on an idle machine of 2026."""

import argparse
import os
import pathlib
import shlex
import statistics
import sys
import tempfile

INCLUDE = pathlib.Path(__file__).resolve().parents[2] / "include"
PROGRAM = """#include <CGAL/Shape_correspondence.h>
#include <iostream>

namespace SC = CGAL::Shape_correspondence;

int main()
{
  SC::Structural_graph source, target;
  std::cout << SC::find_correspondence(source, target).energy << '\\n';
}
"""
LIMIT_SECONDS, LIMIT_MB = 3, 450


def compile_once(source, command):
    """CPU seconds and peak megabytes of one compilation."""
    child = os.posix_spawnp(command[0], command + [str(source)], os.environ)
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"benchmark_compile: {source} does not compile")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def measured(text, folder, command, runs):
    source = pathlib.Path(folder) / "program.cpp"
    source.write_text(text)
    seconds, megabytes = zip(*(compile_once(source, command) for _ in range(runs)))
    return statistics.median(seconds), statistics.median(megabytes)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=5, help="compilations of each; their median is printed")
    parser.add_argument("--headers", action="store_true", help="measure every public header alone, too")
    parser.add_argument("--eigen", default="/usr/include/eigen3", help="folder of Eigen")
    parser.add_argument("--limit", action="store_true", help="fail where the limits are exceeded")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        command = shlex.split(os.environ.get("CXX", "g++")) + [
            "-std=c++17", "-O3", "-DNDEBUG", "-frounding-math", f"-I{INCLUDE}", "-isystem", arguments.eigen,
            "-c", "-o", os.path.join(folder, "program.o")]
        seconds, megabytes = measured(PROGRAM, folder, command, arguments.runs)
        print(f"{seconds:6.2f} s {megabytes:5.0f} MB  a program that calls find_correspondence()", flush=True)
        if arguments.headers:
            for header in sorted((INCLUDE / "CGAL").rglob("*.h")):
                name = header.relative_to(INCLUDE).as_posix()
                if "/internal/" in name:
                    continue
                row = measured(f"#include <{name}>\n", folder, command, arguments.runs)
                print(f"{row[0]:6.2f} s {row[1]:5.0f} MB  {name}", flush=True)
    if arguments.limit and (seconds > LIMIT_SECONDS or megabytes > LIMIT_MB):
        sys.exit(f"benchmark_compile: the limits are {LIMIT_SECONDS} s and {LIMIT_MB} MB")


if __name__ == "__main__":
    main()
