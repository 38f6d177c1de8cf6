#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks what readers of the manual see, in its Markdown and in the built HTML.

  check_manual.py SOURCE_FOLDER HTML_FOLDER

Links and pictures of README.md, CONTRIBUTING.md and the pages lead to files and headings that exist, and README.md links to nothing that is raw
doxygen text; pages have no comments; chapters have at most 3000 words; the HTML shows no asterisk of emphasis that was not recognised.
"""
import glob
import html
import os
import re
import sys

from markdown_for_doxygen import CODE, slug

LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
MOST_WORDS = 3000


def running_text(path):
    with open(path, encoding="utf-8") as file:
        return "".join(CODE.split(file.read())[::2])


def headings(path):
    return {slug(heading) for heading in re.findall(r"^#+ (.*)$", running_text(path), re.M)}


def faults_of_page(path):
    text, folder, name = running_text(path), os.path.dirname(path), os.path.basename(path)
    if "<!--" in text:
        yield "has comments"
    words = len(re.findall(r"\S*[a-zA-Z]\S*", text))
    if words > MOST_WORDS:
        yield f"has {words} words, more than {MOST_WORDS}"
    for url in LINK.findall(re.sub(r"`[^`]*`", "", text)):
        file, _, anchor = url.partition("#")
        target = os.path.join(folder, file) if file else path
        if "://" in url:
            continue
        if not os.path.exists(target):
            yield f"links to {url}, which does not exist"
        elif anchor and anchor not in headings(target):
            yield f"links to {url}, a heading that does not exist"
        elif name == "README.md" and target.endswith(".txt"):
            yield f"links to {url}, which code hosts show as raw text"


def faults_of_html(path):
    with open(path, encoding="utf-8") as file:
        text = re.sub(r"<(head|script|pre|code)\b.*?</\1>", "", file.read(), flags=re.S)
    text = html.unescape(re.sub(r"<[^>]*>", "", re.sub(r'<div class="fragment">.*?</div><!-- fragment -->', "", text, flags=re.S)))
    for match in re.finditer(r"\*", text):
        yield f"shows an asterisk: {text[max(0, match.start() - 30):match.end() + 30]!r}"


def main():
    source, built = sys.argv[1:]
    pages = [os.path.join(source, name) for name in ("README.md", "CONTRIBUTING.md")]
    pages += sorted(glob.glob(os.path.join(source, "doc", "Shape_correspondence", "*.md")))
    faults = [f"{page} {fault}" for page in pages for fault in faults_of_page(page)]
    shown = sorted(glob.glob(os.path.join(built, "sc_*.html"))) + [os.path.join(built, "index.html")]
    faults += [f"{page} {fault}" for page in shown for fault in faults_of_html(page)]
    print(*faults, sep="\n", end="\n" * bool(faults))
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
