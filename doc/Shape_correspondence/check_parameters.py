#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks in doxygen's XML that a reader of the manual learns what each public parameter and field is.

  check_parameters.py XML

- Every field has a comment; in option structures (NAME_options, NAME_weights), every field of a number, truth value or
  enumeration has a default, and a number has a unit or range: one of the words of UNITS.
- Every parameter of a function is described, or named in the function's description, name or type.
- Every named parameter has a description, a type and a default.
"""
import glob
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

UNITS = (r"second|fraction|share|\bin [\[(]|at least|at most|more than|not negative|number of|number that|weight|power|[Cc]ost|"
         r"energy|probability|seed|level|points|maximum|largest|[Mm]in-marginal|smaller|distance|exceed|\|log|one part|nodes|difference|samples|"
         r"volume|[Ll]ength|iterations|gap")
NUMBERS = r"^(int|double|float|long|short|unsigned|std::size_t|std::uint64_t)$"
SIMPLE = NUMBERS[:-2] + r"|bool)$|^(Abstraction_kind|Search_method|Energy_norm|Part_splitting)$"
# Of a stream to write to or read from, and of the two shapes of a match, their names say what they are
TERMS = {"out", "in", "source", "target", "source_file", "target_file"}
# Such functions are like the one before
REPEATED = r"(The same|As above|Like|Samples of a .*as above)"
WORDS = r"[A-Za-z_][A-Za-z_0-9]*"


def text(element):
    return "" if element is None else " ".join("".join(element.itertext()).split())


def comment(member):
    return text(member.find("briefdescription")) + " " + text(member.find("detaileddescription"))


def field_errors(name, field, is_option):
    path = f"{name}::{field.findtext('name')}"
    kind = text(field.find("type"))
    words = comment(field)
    if not words.strip():
        yield f"{path}: no comment"
    if not is_option:
        return
    if re.match(SIMPLE, kind) and field.find("initializer") is None:
        yield f"{path}: no default"
    if re.match(NUMBERS, kind) and not re.search(UNITS, words):
        yield f"{path}: neither unit nor range: {words.strip()}"


def function_errors(name, function):
    path = f"{name}::{function.findtext('name')}()"
    words = comment(function)
    if "operator" in path or not words.strip() or re.match(REPEATED, words.strip()):
        return  # doxygen warns of functions without a comment
    documented = {text(item) for item in function.iter("parametername")}
    mentioned = set(re.findall(WORDS, words.lower().replace("_", " "))) | set(function.findtext("name").split("_"))
    for parameter in function.findall("param"):
        declared = parameter.findtext("declname")
        if not declared or declared in documented or declared in TERMS:
            continue
        # `part_of_piece` is mentioned where all its words are; a type says what it is, as in part_map(correspondence)
        kind = set(re.findall(WORDS, text(parameter.find("type")).lower().replace("_", " ")))
        stems = {word.rstrip("s") for word in mentioned | kind}
        if not all(word.rstrip("s") in stems or len(word) <= 1 and word in words for word in declared.lower().split("_")):
            yield f"{path}: parameter '{declared}' is not described"


def named_parameter_errors(member, name):
    for row in member.iter("row"):
        cells = [text(cell) for cell in row]
        if len(cells) == 2 and "Type:" in "".join(cells) and "Default:" not in cells[1]:
            yield f"{name}: the named parameter {cells[0]} has no default"


def errors_in(file):
    for compound in ElementTree.parse(file).iter("compounddef"):
        name = compound.findtext("compoundname")
        if not name.startswith("CGAL::Shape_correspondence") or compound.get("prot") == "private":
            continue
        is_option = bool(re.search(r"_(options|weights)$", name))
        for member in compound.iter("memberdef"):
            if member.get("prot") != "public" or "internal" in member.get("id"):
                continue
            if member.get("kind") == "variable":
                yield from field_errors(name, member, is_option)
            elif member.get("kind") == "function":
                yield from function_errors(name, member)
                yield from named_parameter_errors(member, f"{name}::{member.findtext('name')}()")


def main():
    files = sorted(glob.glob(os.path.join(sys.argv[1], "*.xml")))
    errors = sorted({error for file in files for error in errors_in(file)})
    print("\n".join(errors))
    sys.exit(1 if errors or not files else 0)


if __name__ == "__main__":
    main()
