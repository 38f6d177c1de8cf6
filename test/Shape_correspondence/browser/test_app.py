#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the page that computes in the browser, in Chromium, and uses it as people do.

  test_app.py PAGE.html DATA [--screenshots FOLDER]

Ends with status 77, which ctest counts as skipped, where there is no Chromium.
"""
import argparse
import base64
import functools
import glob
import gzip
import http.server
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import chromium
from test_pages import AFTER_DRAWING, DESKTOP, LIT, PHONE, PLACE_OF

MOST_TIMES_AS_LONG = 8  # limit for the time in the page over that of the program; machines are noisy
LARGEST_PAGE = 2_140_000  # bytes, compressed as a host sends it
LONGEST_START = 5000  # milliseconds until one can choose models; on an idle machine far less
SCREEN = (1200, 760)
REPOSITORY = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 3)
arguments = None
browser = None

# The names of the tabs, one for each page that the program wrote
TABS = "[...document.querySelectorAll('#tabs button')].map(b => b.textContent)"
IS_IDLE = "document.querySelector('#work').hidden"
ERROR = "document.querySelector('#error').textContent"


class Silent(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def raw(name):
    return os.path.join(arguments.data, "raw", name + ".obj")


class Examples(unittest.TestCase):
    def test_examples_are_unpacked_to_the_bytes_of_the_files(self):
        with open(arguments.page, encoding="utf-8") as file:
            packed = re.search(r'id="examples">([^<]+)<', file.read())[1]
        with open(os.path.join(REPOSITORY, "app", "page", "examples.js"), encoding="utf-8") as file:
            script = file.read().replace("export ", "") + """
                const models = exampleFiles(require('fs').readFileSync(0));
                const text = bytes => new TextDecoder().decode(bytes);
                console.log(JSON.stringify(Object.values(models).flat().map(([path, bytes]) => [path, text(bytes)])))"""
        output = subprocess.run(["node", "-e", script], input=gzip.decompress(base64.b64decode(packed)), check=True, capture_output=True)
        parts = json.loads(output.stdout)
        self.assertEqual(sorted(path for path, _ in parts), sorted(
            os.path.relpath(path, arguments.data) for path in glob.glob(os.path.join(arguments.data, "*", "parts", "*.obj"))))
        for path, text in parts:
            with open(os.path.join(arguments.data, path), encoding="utf-8", newline="") as file:
                self.assertEqual(text, file.read(), path)


class App(unittest.TestCase):
    def setUp(self):
        browser.resize(*SCREEN)
        self.open(arguments.page)

    def open(self, page):
        browser.open(page)
        browser.wait_for("document.body.dataset.ready")
        browser.wait_for(f"document.body.dataset.shown === 'match' && {IS_IDLE}")  # the example

    def tearDown(self):
        errors, requests = browser.heard()
        self.assertEqual(errors, [])
        self.assertEqual([request for request in requests if not request.startswith(("data:", "blob:"))], [])

    def picture(self, name):
        if arguments.screenshots:
            os.makedirs(arguments.screenshots, exist_ok=True)
            with open(os.path.join(arguments.screenshots, name + ".png"), "wb") as file:
                file.write(browser.screenshot())

    def wait(self):
        browser.wait_for(IS_IDLE)
        return browser.evaluate(ERROR)

    def click(self, selector):
        browser.evaluate(f"document.querySelector('{selector}').click()")

    def choose_example(self, side, name):
        browser.evaluate(f"(s => {{ s.value = '{name}'; s.onchange(); }})(document.querySelector('#{side} .choices select'))")
        browser.wait_for(f"document.querySelector('#{side} h2').textContent === '{name}' && {IS_IDLE}")

    def choose_option(self, title, value):
        browser.evaluate(f"(s => {{ s.value = '{value}'; s.onchange(); }})([...document.querySelectorAll('#options label')]"
                         f".find(l => l.firstChild.textContent === '{title}').lastChild)")

    def shown(self):
        """The frame of the page that is shown, once it is drawn."""
        browser.wait_for("document.body.dataset.shown === document.querySelector('#shown').dataset.name")
        frame = browser.inner_frame()
        browser.wait_for("document.body && document.body.dataset.ready", frame)
        browser.evaluate(AFTER_DRAWING, frame)
        return frame

    def drop_two_chairs(self):
        browser.drop(600, 300, [raw("chair_four_legged"), raw("chair_swivel")])
        browser.wait_for(f"document.querySelector('#target h2').textContent === 'chair_swivel.obj' && {IS_IDLE} && !document.querySelector('#match').disabled")
        self.assertEqual(browser.evaluate(ERROR), "")

    def place_in_window(self, frame, view, name):
        x, y = browser.evaluate(f"{PLACE_OF}({view}, '{name}')", frame)
        box = browser.evaluate("(({x, y}) => [x, y])(document.querySelector('#shown').getBoundingClientRect())")
        return x + box[0], y + box[1]

    def test_it_opens_with_a_matched_pair_that_turns_slowly(self):
        yaw = "document.querySelector('#stage').stage.pose.yaw"
        still = browser.evaluate(yaw, self.shown())
        self.assertEqual(browser.evaluate(yaw, self.shown()), still)  # nothing moves where the user prefers reduced motion
        self.assertEqual(browser.evaluate("document.querySelector('.next').id"), "blend")
        browser.allow_motion(True)
        try:
            self.open(arguments.page)
            frame = self.shown()
            browser.wait_for(f"{yaw} > {still} + 0.02", frame)
            browser.click(700, 400)
            browser.wait_for(f"new Promise(done => {{ const before = {yaw}; setTimeout(() => done({yaw} === before), 300); }})", frame)
        finally:
            browser.allow_motion(False)

    def test_two_dropped_files_are_matched_without_a_click_and_blended(self):
        self.picture("before")
        self.assertIn("Drop two models", browser.evaluate("document.querySelector('#next').textContent"))
        self.drop_two_chairs()
        self.assertEqual(browser.evaluate("document.querySelector('#next').textContent + document.querySelector('.next').id"), "blend")
        self.assertEqual(browser.evaluate(TABS), ["First model", "Second model", "Match"])
        frame = self.shown()
        self.picture("match")
        self.assertGreater(browser.evaluate("document.querySelectorAll('tbody tr').length", frame), 3)
        seat = browser.evaluate("document.querySelector('#stage').stage.items.map(i => i.node.name).find(n => /seat/.test(n))", frame)
        browser.click(*self.place_in_window(frame, 0, seat))
        browser.evaluate(AFTER_DRAWING, frame)
        self.assertEqual(browser.evaluate(LIT + "(0)", frame), [seat])
        self.assertEqual(len(browser.evaluate(LIT + "(1)", frame)), 1)
        self.click("#blend")
        self.assertEqual(self.wait(), "")
        frame = self.shown()
        self.picture("blend")
        triangles = "document.querySelector('#stage').stage.items.filter(i => i.tracks).map(i => [i.isHidden, i.object.geometry.attributes.position.array[0]]).join()"
        move = "(s => { s.value = %s; s.oninput(); })(document.querySelector('#player input'))"
        poses = []
        for t in (0, 0.5, 1):
            browser.evaluate(move % t, frame)
            poses.append(browser.evaluate(triangles, frame))
        self.assertEqual(len(set(poses)), 3)
        self.assertEqual(browser.evaluate("document.querySelector('.next').id"), "save")
        saves = browser.evaluate("[...document.querySelectorAll('#saves button')].map(b => b.textContent)")
        self.assertEqual(saves, ["match.html", "match.json", "match.glb", "blend.html", "blend.json", "blend.glb"])

    def test_examples_are_matched_by_every_method(self):
        self.choose_example("source", "stool")
        self.choose_example("target", "chair_four_legged")
        found = {}
        for method in ("", "exact", "paper"):
            self.choose_option("method", method)
            self.click("#match")
            self.assertEqual(self.wait(), "")
            frame = self.shown()
            result = json.loads(browser.evaluate("document.getElementById('match').textContent", frame))
            found[method] = result["search"]["method"] if "search" in result else result["method"]
            self.assertGreater(len(result["pairs"]), 2)
        self.assertEqual(len(set(found.values())), 3)

    def test_parts_are_joined_by_hand(self):
        self.choose_example("source", "stool")
        count = "document.querySelector('#source details summary').textContent"
        before = browser.evaluate(count)
        browser.evaluate("document.querySelectorAll('#source .pieces input[type=checkbox]').forEach((b, i) => { b.checked = i < 2; })")
        browser.evaluate("[...document.querySelectorAll('#source details button')].find(b => b.textContent === 'Join').click()")
        self.assertEqual(self.wait(), "")
        parts, pieces = [int(word) for word in before.split() if word.isdigit()]
        self.assertEqual(browser.evaluate(count), f"Parts by hand: {parts - 1} of {pieces} pieces")
        self.choose_example("target", "chair_four_legged")
        self.assertEqual(self.wait(), "")
        frame = self.shown()
        source = "document.querySelector('#stage').stage.items.filter(i => i.layer === 'surfaces' && i.view.caption.textContent === 'stool').length"
        self.assertEqual(browser.evaluate(source, frame), parts - 1)

    def test_errors_say_what_is_wrong_and_the_page_goes_on(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, content, words in (("torn.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n", ("torn.obj", "vertex")),
                                         ("empty.stl", "", ("empty.stl", "empty")),
                                         ("chair.glb", "glTF", ("chair.glb", "cut off")),
                                         ("chair.fbx", "Kaydara", ("chair.fbx", "save the model as GLB")),
                                         ("notes.txt", "chair", ("There is no model",))):
                path = os.path.join(folder, name)
                with open(path, "w", encoding="utf-8") as file:
                    file.write(content)
                browser.drop(600, 300, [path])
                browser.wait_for(f"{IS_IDLE} && {ERROR}")
                if name == "torn.obj":
                    self.picture("error")
                for word in words:
                    self.assertIn(word, browser.evaluate(ERROR))
                self.assertNotIn("source/", browser.evaluate(ERROR))  # a folder in the file system of the module
                browser.evaluate("document.querySelector('#error').textContent = ''")
            browser.drop(600, 300, [raw("chair_swivel")] * 3)
            browser.wait_for(ERROR)
            self.assertIn("3 models", browser.evaluate(ERROR))
        self.drop_two_chairs()

    def test_a_match_is_cancelled_and_made_again(self):
        self.choose_example("source", "bicycle")
        browser.evaluate("(s => { s.value = 'tricycle'; s.onchange(); })(document.querySelector('#target .choices select'))")
        browser.wait_for("/^Matching.* of /.test(document.querySelector('#work p').textContent)")
        self.click("#cancel")
        self.assertEqual(self.wait(), "")
        self.assertNotIn("Match", browser.evaluate(TABS))
        self.click("#match")
        self.assertEqual(self.wait(), "")
        self.assertIn("Match", browser.evaluate(TABS))

    def test_a_phone(self):
        browser.resize(*PHONE, is_phone=True)
        self.open(arguments.page)
        self.picture("phone_before")
        self.choose_example("source", "chair_four_legged")
        self.choose_example("target", "chair_swivel")
        self.assertEqual(self.wait(), "")
        self.shown()
        self.assertEqual(browser.evaluate("document.documentElement.scrollWidth"), browser.evaluate("innerWidth"))
        top, bottom = browser.evaluate("(({top, bottom}) => [top, bottom])(document.querySelector('#results').getBoundingClientRect())")
        self.assertAlmostEqual(top, 0, delta=1)  # the match fills the screen
        self.assertGreaterEqual(bottom, browser.evaluate("innerHeight"))
        self.picture("phone_after")

    def test_from_a_static_host(self):
        handler = functools.partial(Silent, directory=os.path.dirname(os.path.abspath(arguments.page)))
        with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
            threading.Thread(target=server.serve_forever, daemon=True).start()
            self.open(f"http://127.0.0.1:{server.server_port}/{os.path.basename(arguments.page)}")
            self.choose_example("source", "stool")
            self.shown()
            server.shutdown()

    def test_the_page_is_small_and_starts_soon(self):
        with open(arguments.page, "rb") as file:
            size = len(gzip.compress(file.read(), 6))
        starts = browser.evaluate("Number(document.body.dataset.ready)")
        print(f"{size} bytes packed; {starts} ms until models can be chosen")
        self.assertLess(size, LARGEST_PAGE)
        self.assertLess(starts, LONGEST_START)

    def test_two_chairs_are_matched_soon(self):
        chairs = "chair_slatted", "chair_spindle"
        if not arguments.program:
            self.skipTest("no --program to compare with")
        ratios = []
        for _ in range(5):
            self.open(arguments.page)
            for side, chair in zip(("source", "target"), chairs):
                self.choose_example(side, chair)
            self.assertEqual(self.wait(), "")
            in_page, memory = browser.evaluate("[Number(document.body.dataset.seconds), Number(document.body.dataset.memory)]")
            with tempfile.TemporaryDirectory() as folder:
                start = time.perf_counter()
                subprocess.run([arguments.program, "match", *(os.path.join(arguments.data, chair) for chair in chairs), "--quiet",
                                "--threads", "1", "--html", os.path.join(folder, "match.html"),
                                "--json", os.path.join(folder, "match.json"), "--glb", os.path.join(folder, "match.glb")], check=True, stdout=subprocess.DEVNULL)
                ratios.append(in_page / (time.perf_counter() - start))
        ratio = statistics.median(ratios)
        print(f"two chairs are matched {ratio:.1f} times as long as by the program; the module takes {memory / 1e6:.0f} MB")
        self.assertLess(ratio, MOST_TIMES_AS_LONG)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page")
    parser.add_argument("data")
    parser.add_argument("--screenshots", metavar="FOLDER", help="keep pictures of the page here")
    parser.add_argument("--program", help="the native program, to compare times with")
    arguments, rest = parser.parse_known_args()
    if not chromium.find():
        print("skipped: there is no Chromium")
        sys.exit(77)
    with chromium.Browser(chromium.find()) as browser:
        outcome = unittest.main(argv=[sys.argv[0], *rest], exit=False).result
    sys.exit(not outcome.wasSuccessful())
