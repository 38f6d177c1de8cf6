#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Doxygen's filter of Markdown pages: prints a page with the commands of doxygen.

  markdown_for_doxygen.py PAGE.md

The pages are plain Markdown, as code hosts show it. Page X.md is \\page sc_x, and its section "Two Words" is sc_x__two_words; links to pages,
sections and examples become references, pictures with a caption in italics become figures of CGAL's manual.
"""
import os
import re
import sys

CODE = re.compile(r"^(```\w*\n.*?^```\n)", re.M | re.S)
LINK = re.compile(r"(?<!!)\[([^\]]+)\]\(([^)\s]+)\)")
FIGURE = re.compile(r"^!\[[^\]]*\]\(fig/([\w.]+)\)\n\n\*((?:[^*\n]|\n(?!\n))+)\*$", re.M)
LANGUAGES = {"bash": "sh", "python": "py", "text": "unparsed", "cmake": "unparsed", "json": "unparsed"}


def slug(heading):
    """The anchor that code hosts give to a heading."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def label(page, anchor=""):
    return f"sc_{page.lower()}" + (f"__{anchor.replace('-', '_')}" if anchor else "")


def reference(text, url, page):
    """A link as doxygen's reference; of files that are not in the manual, the text."""
    path, _, anchor = url.partition("#")
    plain = re.sub(r"[`*]", "", text).replace('"', "'").replace("\n", " ")
    if "://" in url:
        return f"[{text}]({url})"
    if path.startswith("../../examples/"):
        return f'\\ref {path[len("../../examples/"):]} "{plain}"'
    if path.startswith("../../include/"):
        return f'\\ref PkgShapeCorrespondenceRef "{plain}"'
    if "/" in path or (path and not path.endswith(".md")):
        return text
    return f'\\ref {label(path[:-3] or page, anchor)} "{plain}"'


def running_text(text, page):
    text = re.sub(r"^Example: \[[^\]]*\]\(\.\./\.\./examples/([^)]*)\)$", r"\\cgalExample{\1}", text, flags=re.M)
    text = FIGURE.sub(lambda m: f"\\cgalFigureBegin{{{label(page, m[1].split('.')[0])}_figure,{m[1]}}}\n{m[2]}\n\\cgalFigureEnd", text)
    text = LINK.sub(lambda m: reference(m[1], m[2], page), text)
    text = re.sub(r"`[^`]*`", lambda m: re.sub(r"%(?=\w)", "%%", m[0]), text)
    text = re.sub(r"^# (.*)$", lambda m: f"# {m[1]} {{#{label(page)}}}", text, count=1, flags=re.M)
    for marks, command in (("##", "section"), ("###", "subsection")):
        text = re.sub(rf"^{marks} (.*)$", lambda m: f"\\{command} {label(page, slug(m[1]))} {m[1]}", text, flags=re.M)
    return text


def code(text):
    language, body = re.match(r"```(\w*)\n(.*)```\n", text, re.S).groups()
    return f"\\code{{.{LANGUAGES.get(language, language or 'unparsed')}}}\n{body}\\endcode\n"


def main():
    page = os.path.splitext(os.path.basename(sys.argv[1]))[0]
    with open(sys.argv[1], encoding="utf-8") as file:
        chunks = CODE.split(file.read())
    sys.stdout.reconfigure(encoding="utf-8")
    sys.stdout.write("".join(code(chunk) if i % 2 else running_text(chunk, page) for i, chunk in enumerate(chunks)))


if __name__ == "__main__":
    main()
