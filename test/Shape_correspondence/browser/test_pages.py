#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the pages that the program writes in Chromium and uses them as people do.

  test_pages.py PROGRAM DATA [--screenshots FOLDER]

Ends with status 77, which ctest counts as skipped, where there is no Chromium.
"""
import argparse
import glob
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import chromium

HERE = os.path.dirname(os.path.abspath(__file__))
DESKTOP, PHONE = (900, 560), (390, 844)
LARGEST_PAGE = 8 << 20
LARGEST_SCRIPT = 510000  # characters, if Python made it of three.module.js
arguments = None
browser = None
pages = {}

# A point of the window at which a part of a view is under the pointer
PLACE_OF = """((view, name) => {
  const stage = document.querySelector('#stage').stage, {camera} = stage.views[view];
  const {left, top, width, height} = stage.boxOf(stage.views[view]);
  for (const {object, node} of stage.items.filter(i => i.view === stage.views[view] && i.node.name === name)) {
    const {index, attributes} = object.geometry;
    for (let t = 0; t < index.count; t += 3 * Math.ceil(index.count / 150)) {
      const middle = new THREE.Vector3();
      for (let k = 0; k < 3; ++k)
        middle.add(new THREE.Vector3().fromBufferAttribute(attributes.position, index.getX(t + k)).divideScalar(3));
      middle.applyMatrix4(object.matrixWorld).project(camera);
      const [x, y] = [left + (middle.x + 1) / 2 * width, top + (1 - middle.y) / 2 * height], item = stage.itemAt(x, y);
      if (item && item.node === node) return [x, y];
    }
  }
})"""
# The parts of a view that are not faded
LIT = """(view => {
  const stage = document.querySelector('#stage').stage;
  return stage.items.filter(item => item.view === stage.views[view] && item.layer === 'surfaces' && item.object.visible &&
                            item.object.material.opacity > 0.5).map(item => item.node.name);
})"""
AFTER_DRAWING = "new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))"


def rows_of(png):
    """The pixels of a PNG of 8 bits a channel: rows of tuples."""
    at, data = 8, b""
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        if kind == b"IHDR":
            width, _, _, colours = struct.unpack(">IIBB", png[at + 8:at + 18])
        if kind == b"IDAT":
            data += png[at + 8:at + 8 + size]
        at += 12 + size
    channels = {2: 3, 6: 4}[colours]
    data, stride, result = zlib.decompress(data), width * channels, []
    before = bytes(stride)
    for begin in range(0, len(data), stride + 1):
        kind, row = data[begin], bytearray(data[begin + 1:begin + 1 + stride])
        for x in range(stride):
            left, corner = (row[x - channels], before[x - channels]) if x >= channels else (0, 0)
            up = before[x]
            guess = left + up - corner  # of Paeth's predictor
            row[x] = (row[x] + (0, left, up, (left + up) // 2,
                                min((left, up, corner), key=lambda v: abs(guess - v)))[kind]) & 255
        result.append([tuple(row[x:x + 3]) for x in range(0, stride, channels)])
        before = row
    return result


def setUpModule():
    global browser
    browser = chromium.Browser(chromium.find()).__enter__()
    folder = setUpModule.folder = tempfile.TemporaryDirectory()
    shapes = {name: os.path.join(arguments.data, name) for name in os.listdir(arguments.data)}
    chairs = [shapes[name] for name in ("chair_four_legged", "chair_spindle", "stool")]
    cache = ["--cache", os.path.join(folder.name, "cache"), "--quiet"]
    path = lambda name: os.path.join(folder.name, name + ".html")
    commands = {"match": ["match", *chairs[:2], "--html", path("match"), *cache],
                "graph": ["graph", chairs[1], "--html", path("graph"), *cache],
                "blend": ["blend", *chairs[:2], "--frames", "5", "-o", path("blend"), *cache],
                "collection": ["collection", *chairs, "--html", path("collection"), *cache],
                "parts": ["parts", *chairs, "--html", path("parts"), "--quiet"]}
    for name, command in commands.items():
        subprocess.run([arguments.program, *command], check=True)
        pages[name] = path(name)


def tearDownModule():
    browser.__exit__()
    setUpModule.folder.cleanup()


class Pages(unittest.TestCase):
    def open(self, name, size=DESKTOP):
        browser.resize(*size, is_phone=size == PHONE)
        errors, requests = browser.open(pages[name])
        browser.wait_for("document.body.dataset.ready")
        if size == PHONE:  # shows the models, since pages of sets open with the set
            browser.evaluate("document.body.dataset.tab = 'models'")
        browser.evaluate(AFTER_DRAWING)
        self.assertEqual(errors, [])
        self.assertEqual([request for request in requests if not request.startswith("data:")], [])

    def check_picture(self, name):
        """Checks that neither the stage nor the window is blank."""
        if arguments.screenshots:
            os.makedirs(arguments.screenshots, exist_ok=True)
            with open(os.path.join(arguments.screenshots, name + ".png"), "wb") as file:
                file.write(browser.screenshot())
        box = browser.evaluate("(({x, y, width, height}) => ({x: x + scrollX, y: y + scrollY, width, height}))"
                               "(document.querySelector('#stage').getBoundingClientRect())")
        colours = [c for row in rows_of(browser.screenshot(clip={**box, "scale": 0.15})) for c in row]
        drawn = [c for c in colours if min(c) < 225]
        self.assertGreater(len(drawn), 0.03 * len(colours))
        self.assertGreater(len(set(drawn)), 20)
        self.assertEqual(browser.evaluate("document.documentElement.scrollWidth"), browser.evaluate("innerWidth"))

    def place_of(self, view, name):
        place = browser.evaluate(f"{PLACE_OF}({view}, '{name}')")
        self.assertIsNotNone(place, name)
        return place

    def lit(self, view):
        browser.evaluate(AFTER_DRAWING)
        return browser.evaluate(f"{LIT}({view})")

    def test_every_page_opens_without_errors_or_requests_on_desktop_and_phone(self):
        for name in pages:
            for size in (DESKTOP, PHONE):
                with self.subTest(page=name, size=size):
                    self.open(name, size)
                    self.check_picture(name + ("_phone" if size == PHONE else ""))

    def test_a_part_that_is_pointed_at_or_clicked_lights_its_counterparts(self):
        self.open("match")
        self.assertEqual(len(self.lit(0)), 12)
        x, y = self.place_of(0, "front_left_leg")
        browser.mouse("mouseMoved", x, y)
        browser.wait_for("document.querySelector('#tip').style.display === 'block'")
        tip = browser.evaluate("document.querySelector('#tip').innerText")
        for text in ("front_left_leg", "role: ", "one part matches one part", "in chair_spindle: turned_leg_a", "confidence: "):
            self.assertIn(text, tip)
        self.assertEqual((self.lit(0), self.lit(1)), (["front_left_leg"], ["turned_leg_a"]))
        browser.mouse("mouseMoved", 5, 5)
        browser.wait_for("document.querySelector('#tip').style.display === 'none'")
        self.assertEqual(len(self.lit(0)), 12)

        browser.click(*self.place_of(1, "turned_leg_c"))
        browser.mouse("mouseMoved", 5, 5)
        self.assertEqual((self.lit(0), self.lit(1)), (["rear_left_leg"], ["turned_leg_c"]))
        self.assertIn("rear_left_leg", browser.evaluate("document.querySelector('tr.part.lit').textContent"))
        browser.call("Input.dispatchKeyEvent", type="keyDown", key="Escape")
        self.assertEqual(len(self.lit(1)), 16)

    def test_a_row_and_the_search_light_parts(self):
        self.open("match")
        row = "[...document.querySelectorAll('tbody tr')].find(tr => tr.textContent.includes('seat matches saddle_seat'))"
        browser.evaluate(row + ".onmouseenter()")
        self.assertEqual((self.lit(0), self.lit(1)), (["seat"], ["saddle_seat"]))
        browser.evaluate(row + ".onmouseleave()")
        browser.evaluate("(s => { s.value = 'turned_leg_B'; s.oninput(); })(document.querySelector('#search'))")
        self.assertEqual(browser.evaluate("document.querySelectorAll('tbody tr:not(.part):not([hidden])').length"), 1)
        self.assertEqual((self.lit(0), self.lit(1)), (["front_right_leg"], ["turned_leg_b"]))

    def test_a_row_folds_its_parts(self):
        self.open("match")
        row = "[...document.querySelectorAll('tbody tr')].find(tr => tr.cells[1].textContent === 'back')"
        shown = "document.querySelectorAll('tr.part:not([hidden])').length"
        self.assertEqual(browser.evaluate(shown), 0)
        browser.evaluate(row + ".querySelector('button').click()")
        self.assertGreater(browser.evaluate(shown), 2)
        self.assertIn("become", browser.evaluate(row + ".cells[2].textContent"))
        self.assertRegex(browser.evaluate(row + ".cells[2].title"), r"^\w+ \d+:\d+: ")  # the operation's code word
        self.assertEqual(browser.evaluate(row + ".querySelector('button').ariaExpanded"), "true")
        browser.evaluate("document.querySelector('tr.part:not([hidden]) td:nth-child(3)').onmouseenter()")
        self.assertEqual((len(self.lit(0)), self.lit(1)), (1, []))
        browser.evaluate(row + ".querySelector('button').click()")
        self.assertEqual(browser.evaluate(shown), 0)

    def test_the_slider_hides_what_is_unsure(self):
        self.open("match")
        rows = "document.querySelectorAll('tbody tr:not([hidden])').length"
        before = browser.evaluate(rows)
        grey = "new Set(document.querySelector('#stage').stage.items.filter(i => i.part >= 0).map(i => JSON.stringify(i.colour))).size"
        colours = browser.evaluate(grey)
        browser.evaluate("(s => { s.value = 0.95; s.oninput(); })(document.querySelector('#tools input[type=range]'))")
        self.assertLess(browser.evaluate(rows), before)
        self.assertLess(browser.evaluate(grey), colours)
        self.assertRegex(browser.evaluate("document.querySelector('#facts').textContent"), r"Hidden, because they are below 95 %, and drawn faint: .*\d parts? and their \d+ counterparts?\.")
        self.assertEqual(browser.evaluate("document.querySelector('#show > summary').textContent"), "Show (filtered)")
        self.open("blend")
        browser.evaluate("(s => { s.value = 0.95; s.oninput(); })(document.querySelector('#tools input[type=range]'))")
        faint = browser.evaluate("document.querySelectorAll('.bars span.faint').length")
        self.assertTrue(0 < faint < browser.evaluate("document.querySelectorAll('.bars > span').length / 2"))

    def test_labels_stand_with_contacts_shown(self):
        self.open("match", (1440, 900))
        stage = "document.querySelector('#stage').stage"
        before = browser.evaluate(f"{stage}.labels().map(label => label.text).sort()")
        for layer in ("contacts", "curves and sheets"):
            browser.evaluate(f"{stage}.setLayer('{layer}', true)")
            browser.evaluate(AFTER_DRAWING)
        browser.evaluate(f"{stage}.setLayer('curves and sheets', false)")
        self.assertEqual(browser.evaluate(f"{stage}.labels().map(label => label.text).sort()"), before)
        for x in range(50, 800, 150):
            browser.mouse("mouseMoved", x, 400)
        browser.evaluate(AFTER_DRAWING)
        self.assertEqual(browser.heard()[0], [])

    def test_a_film_says_what_it_leaves_out_of_the_match(self):
        path = os.path.join(setUpModule.folder.name, "thinned.html")
        chairs = [os.path.join(arguments.data, name) for name in ("chair_four_legged", "chair_swivel")]
        subprocess.run([arguments.program, "blend", *chairs, "--frames", "3", "--html", path, "--quiet"], check=True)
        pages["thinned"] = path
        self.open("thinned")
        self.assertEqual(browser.evaluate("document.querySelector('h1').textContent"), "From chair_four_legged to chair_swivel")
        self.assertRegex(browser.evaluate("document.querySelector('#facts').textContent"), r"^Press Play: .* \d+ less probable pairs of the match are left out")
        line = "(t => { const s = document.querySelector('#player input'); s.value = t; s.oninput(); const bar = document.querySelector('.bars > span:nth-of-type(2)').getBoundingClientRect(), {left, width} = s.getBoundingClientRect(); return [bar.left + t * bar.width, left + 10 + t * (width - 20)]; })"
        for t in (0, 0.25, 1):  # the bars and the thumb of the slider show the same time
            bar, thumb = browser.evaluate(f"{line}({t})")
            self.assertAlmostEqual(bar, thumb, delta=1)
        self.assertEqual(browser.evaluate("document.querySelector('.between figcaption').textContent"), "chair_swivel")
        del pages["thinned"]

    def test_keys(self):
        self.open("match")
        pose = "({...document.querySelector('#stage').stage.pose})"
        before = browser.evaluate(pose)
        browser.evaluate("document.querySelector('#stage').focus()")
        press = lambda key: browser.call("Input.dispatchKeyEvent", type="keyDown", key=key)
        press("ArrowLeft")
        press("+")
        after = browser.evaluate(pose)
        self.assertGreater(after["yaw"], before["yaw"])
        self.assertLess(after["zoom"], before["zoom"])
        press("Home")
        self.assertEqual(browser.evaluate(pose), before)
        browser.evaluate("document.querySelector('tbody tr').focus()")
        press(" ")
        self.assertEqual(browser.evaluate("document.querySelectorAll('tr[aria-selected=true]:not(.part)').length"), 1)
        press("Enter")
        self.assertEqual(browser.evaluate("document.querySelectorAll('tr[aria-selected=true]').length"), 0)

    def test_the_table_without_webgl_and_the_summary_without_scripts(self):
        with open(pages["match"], encoding="utf-8") as file:
            text = file.read()
        self.assertTrue(re.search(r"<noscript>[^@]*[\n>]back: [^\n]* → [^@]*</noscript>", text))
        with chromium.Browser(chromium.find(), "--disable-3d-apis") as other:
            errors, _ = other.open(pages["match"])
            other.wait_for("document.body.dataset.ready")
            self.assertEqual(errors, [])
            self.assertGreater(other.evaluate("document.querySelectorAll('tbody tr').length"), 3)
            self.assertIn("WebGL", other.evaluate("document.querySelector('#stage').innerText"))

    def test_switches_of_layers_groups_and_links(self):
        self.open("match")
        switch = "(text => [...document.querySelectorAll('#tools label')].find(l => l.innerText.trim() === text).firstChild.click())"
        visible = "(l => document.querySelector('#stage').stage.items.filter(i => i.layer === l && i.object.visible).length)"
        browser.evaluate("document.querySelector('#show').open = true")
        self.assertEqual(browser.evaluate(visible + "('curves and sheets')"), 0)
        for layer, items in (("curves and sheets", 28), ("contacts", 2)):
            browser.evaluate(f"{switch}('{layer}')")
            browser.evaluate(AFTER_DRAWING)
            self.assertEqual(browser.evaluate(f"{visible}('{layer}')"), items)
        browser.evaluate(switch + "('surfaces')")
        browser.evaluate(AFTER_DRAWING)
        self.assertEqual(browser.evaluate(visible + "('surfaces')"), 0)
        browser.evaluate(switch + "('surfaces')")
        browser.evaluate(switch + "('curves and sheets')")
        browser.evaluate(switch + "('groups')")
        browser.click(*self.place_of(0, "front_left_leg"))
        self.assertEqual(sorted(self.lit(0)), ["front_left_leg", "front_right_leg"])
        swatches = "new Set([...document.querySelectorAll('tr.part.lit i')].map(i => i.style.backgroundColor)).size"
        self.assertEqual(browser.evaluate(swatches), 1)
        drawn = """(c => c.getContext('2d').getImageData(0, 0, c.width, c.height).data.some(v => v > 0))(
                   document.querySelector('.links'))"""
        browser.evaluate("document.querySelector('#show').open = true")  # a click beside it has closed it
        browser.evaluate(switch + "('labels')")
        browser.evaluate(AFTER_DRAWING)
        self.assertFalse(browser.evaluate(drawn))
        browser.evaluate(switch + "('links')")
        browser.evaluate(AFTER_DRAWING)
        self.assertTrue(browser.evaluate(drawn))

    def test_drag_turns_both_shapes_and_the_wheel_zooms(self):
        self.open("match")
        pose = "({...document.querySelector('#stage').stage.pose})"
        before = browser.evaluate(pose)
        browser.mouse("mousePressed", 200, 300, "left", buttons=1)
        browser.mouse("mouseMoved", 260, 300, "left", buttons=1)
        browser.mouse("mouseReleased", 260, 300, "left")
        browser.mouse("mouseWheel", 200, 300, deltaX=0, deltaY=200)
        after = browser.evaluate(pose)
        self.assertLess(after["yaw"], before["yaw"])
        self.assertGreater(after["zoom"], before["zoom"])
        self.assertEqual(len(self.lit(0)), 12)  # a drag is no click

    def test_fingers_on_a_phone(self):
        self.open("match", PHONE)
        self.assertFalse(browser.evaluate("document.querySelector('#stage').classList.contains('stacked')"))
        browser.tap(*self.place_of(0, "seat"))
        browser.wait_for("document.querySelector('#tip').style.display === 'block'")
        self.assertEqual((self.lit(0), self.lit(1)), (["seat"], ["saddle_seat"]))
        touch = lambda kind, *points: browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=[
            {"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)])
        zoom = "document.querySelector('#stage').stage.pose.zoom"
        touch("touchStart", (150, 300), (200, 300))
        touch("touchMove", (120, 300), (230, 300))
        touch("touchMove", (100, 300), (250, 300))
        touch("touchEnd")
        self.assertLess(browser.evaluate(zoom), 0.8)

    def test_the_slider_moves_vertices_and_play_plays(self):
        self.open("blend")
        points = """JSON.stringify(document.querySelector('#stage').stage.items.filter(i => i.sides && i.object.visible).map(
                    i => [i.node.name, i.object.geometry.attributes.position.array.slice(0, 9)]))"""
        slide = "(t => { const s = document.querySelector('#player input'); s.value = t; s.oninput(); })"
        seen = []
        for t in (0, 0.3, 0.31, 1):
            browser.evaluate(f"{slide}({t})")
            browser.evaluate(AFTER_DRAWING)
            seen.append(browser.evaluate(points))
        self.assertEqual(len(set(seen)), 4)
        self.assertIn("front_left_leg", seen[0])
        self.assertIn("turned_leg_a", seen[3])
        roles = browser.evaluate("[...document.querySelectorAll('.bars > span:nth-child(odd)')].map(span => span.textContent)")
        self.assertIn("seat", roles)
        self.assertEqual(len(roles), len(set(roles)))  # one bar for each role
        tasks = browser.evaluate("[...document.querySelectorAll('.bars > span:nth-child(even)')].flatMap(span => span.title.split('\\n')).length")
        self.assertEqual(tasks, browser.evaluate("JSON.parse(document.querySelector('#blend').textContent).tasks.length"))
        browser.evaluate(slide + "(0.2)")
        browser.evaluate("document.querySelector('#player button').click()")
        browser.wait_for("Number(document.querySelector('#player input').value) > 0.25")
        browser.evaluate("document.querySelector('#player button').click()")
        self.check_picture("blend_playing")

    def test_a_blend_plays_when_it_is_opened_unless_motion_is_unwanted(self):
        time = "Number(document.querySelector('#player input').value)"
        self.open("blend")
        self.assertEqual(browser.evaluate("document.querySelector('#player button').textContent"), "Play")
        self.assertEqual(browser.evaluate(time), 0.5)
        browser.allow_motion(True)
        try:
            self.open("blend")
            browser.wait_for(time + " > 0")
            self.assertEqual(browser.evaluate("document.querySelector('#player button').textContent"), "Pause")
        finally:
            browser.allow_motion(False)
        sizes = browser.evaluate("[...document.querySelectorAll('button')].map(b => b.offsetWidth * b.offsetHeight)")
        self.assertEqual(max(sizes), browser.evaluate("(b => b.offsetWidth * b.offsetHeight)(document.querySelector('#player button'))"))
        areas = browser.evaluate("document.querySelector('#stage').stage.views.map(v => v.figure.offsetWidth * v.figure.offsetHeight)")
        self.assertGreater(areas[2], 2 * max(areas[:2]))

    def test_a_role_has_one_colour_on_all_pages(self):
        seats = {}
        for name in pages:
            self.open(name)
            seats[name] = browser.evaluate(
                "document.querySelector('#stage').stage.items.find(i => /^(saddle_)?seat$/.test(i.node.name)).mesh.colour.join()" if name in ("match", "blend", "collection")
                else "document.querySelector('#stage').stage.items.find(i => /^(saddle_)?seat$/.test(i.node.name)).colour.toArray().join()")
            seats[name] = tuple(round(float(value), 2) for value in seats[name].split(",")[:3])
        self.assertEqual(len(set(seats.values())), 1, seats)

    def test_certainty_is_seen(self):
        with open(pages["match"], encoding="utf-8") as file:
            text = file.read()
        begin = text.index('id="match">') + len('id="match">')
        end = text.index("</script>", begin)
        match = json.loads(text[begin:end])
        match["confidences"] = [0.1 if "turned_leg_a" in pair else value for pair, value in zip(match["pairs"], match["confidences"])]
        for block in match["blocks"]:
            if block["target"] == ["turned_leg_a"]:
                block["confidence"] = 0.1
        pages["unsure"] = pages["match"].replace(".html", "_unsure.html")
        with open(pages["unsure"], "w", encoding="utf-8") as file:
            file.write(text[:begin] + json.dumps(match) + text[end:])
        look = """(name => { const item = document.querySelector('#stage').stage.items.find(i => i.node.name === name);
                    return [JSON.stringify(item.colour), item.hatch]; })"""
        told = "document.querySelector('#facts').textContent"
        self.open("match")
        self.assertNotIn("Striped", browser.evaluate(told))
        self.open("unsure")
        (colour, is_hatched), (other, is_other_hatched), counterpart = [browser.evaluate(f"{look}('{name}')") for name in ("turned_leg_a", "turned_leg_b", "front_left_leg")]
        self.assertEqual(counterpart, [colour, 1])  # striped, but in the colour of its counterpart
        self.assertEqual((is_hatched, is_other_hatched), (1, 0))
        self.assertIn("Striped parts are unsure, less than 50 %.", browser.evaluate(told))
        self.assertIn("least 10 %", browser.evaluate("document.querySelector('table').textContent"))
        striped = [browser.evaluate(f"document.querySelectorAll('{rows} i.{kind}').length") for rows in ("tr:not(.part)", "tr.part") for kind in ("unsure", "partly")]
        self.assertEqual(striped, [0, 1, 1, 0])  # striped in part: the row of all blocks of a role; entirely: the row of a block below it
        del pages["unsure"]

    def test_roles_stand_at_the_parts(self):
        self.open("match", (1440, 900))
        stage = "document.querySelector('#stage').stage"
        placed = browser.evaluate(f"{stage}.labels().map(label => [label.text, label.x, label.y])")
        self.assertTrue({"seat", "back", "leg"} <= {text for text, _, _ in placed})
        for text, x, y in placed:
            item = browser.evaluate(f"(item => item && item.node.name)({stage}.itemAt({x}, {y}))")
            self.assertIsNotNone(item, text)
        browser.evaluate(f"{stage}.pose.zoom = 20; {stage}.draw()")  # far away, small parts have no labels
        self.assertLess(browser.evaluate(f"{stage}.labels().length"), len(placed))

    def test_a_table_has_at_most_ten_rows_and_labels_of_at_most_24_characters(self):
        self.open("match")
        self.assertLessEqual(browser.evaluate("document.querySelectorAll('tbody tr:not(.part)').length"), 10)
        labels = json.loads(browser.evaluate("document.querySelector('#labels').textContent"))
        self.assertLessEqual(max(len(label) for side in labels for label in side), 24)

    def test_a_phone_has_tabs_in_place_of_a_long_page(self):
        for name in pages:
            with self.subTest(page=name):
                self.open(name, PHONE)
                self.assertLessEqual(browser.evaluate("document.documentElement.scrollHeight"), PHONE[1])
                browser.evaluate("[...document.querySelectorAll('#tabs button')].pop().click()")
                self.assertGreater(browser.evaluate("document.querySelector('table').offsetHeight"), 0)
                small = browser.evaluate("[...document.querySelectorAll('button, tbody tr, #search, summary')].filter(e => e.offsetHeight && !e.closest('td, header, #told') && e.offsetHeight < 39).length")
                self.assertEqual(small, 0)

    def test_parts_are_joined_by_clicks_as_match_takes_them(self):
        self.open("parts")
        browser.evaluate("document.querySelector('#gallery button[title=stool]').click()")
        browser.evaluate(AFTER_DRAWING)
        rows = "document.querySelectorAll('tbody tr').length"
        before = browser.evaluate(rows)
        for name in browser.evaluate("[...document.querySelectorAll('tbody tr')].slice(0, 2).map((_, i) => i)"):
            browser.evaluate(f"document.querySelectorAll('tbody tr')[{name}].onclick(new Event('click'))")
        button = "[...document.querySelectorAll('#told button')].find(b => b.textContent.startsWith('{}'))"
        browser.evaluate(button.format("Join 2") + ".click()")
        self.assertEqual(browser.evaluate(rows), before - 1)
        self.assertFalse(browser.evaluate(button.format("Save") + ".disabled"))
        path = os.path.join(setUpModule.folder.name, "stool.parts.json")
        with open(path, "w", encoding="utf-8") as file:
            file.write(browser.evaluate("document.querySelector('#stage').partsFile()"))
        stool, chair = (os.path.join(arguments.data, name) for name in ("stool", "chair_spindle"))
        result = subprocess.run([arguments.program, "match", stool, chair, "--source-parts-from", path, "--json", "-", "--quiet"], check=True, capture_output=True)
        match = json.loads(result.stdout)
        self.assertEqual(len({pair[0] for pair in match["pairs"]} | set(match["unmatched_source"])), before - 1)

    def test_found_parts_are_joined_and_divided_along_their_tree(self):
        one, page = (os.path.join(setUpModule.folder.name, name) for name in ("one.obj", "one.html"))
        with open(one, "w", encoding="utf-8") as file:  # a chair as one object
            points = 0
            for part in sorted(glob.glob(os.path.join(arguments.data, "chair_four_legged", "parts", "*.obj"))):
                with open(part, encoding="utf-8") as lines:
                    rows = [line.split() for line in lines]
                file.writelines("v " + " ".join(row[1:4]) + "\n" for row in rows if row[:1] == ["v"])
                file.writelines("f " + " ".join(str(int(word.split("/")[0]) + points) for word in row[1:]) + "\n" for row in rows if row[:1] == ["f"])
                points += sum(row[:1] == ["v"] for row in rows)
        subprocess.run([arguments.program, "parts", one, "--html", page, "--quiet"], check=True)
        pages["one"] = page
        self.open("one")
        del pages["one"]
        rows = "document.querySelectorAll('tbody tr').length"
        click = "[...document.querySelectorAll('#told button')].find(b => b.textContent.startsWith('{}')).click()"
        before = browser.evaluate(rows)
        browser.evaluate("document.querySelector('tbody tr').onclick(new Event('click'))")
        browser.evaluate(click.format("Join"))
        joined = browser.evaluate(rows)
        self.assertLess(joined, before)
        path = os.path.join(setUpModule.folder.name, "one.parts.json")
        with open(path, "w", encoding="utf-8") as file:
            file.write(browser.evaluate("document.querySelector('#stage').partsFile()"))
        graph = subprocess.run([arguments.program, "graph", one, "--parts-from", path, "--json", "-", "--quiet"], check=True, capture_output=True)
        self.assertEqual(len(json.loads(graph.stdout)["parts"]), joined)
        browser.evaluate(click.format("Divide"))
        self.assertGreater(browser.evaluate(rows), joined)
        browser.evaluate(click.format("Undo all"))
        self.assertEqual(browser.evaluate(rows), before)

    def test_a_collection_shows_the_match_of_two_shapes_in_the_colours_of_clusters(self):
        self.open("collection")
        self.assertEqual(browser.evaluate("document.querySelectorAll('#gallery button').length"), 3)
        self.assertEqual(browser.evaluate("document.querySelectorAll('#tree button').length"), 3)
        for name in ("chair_four_legged", "chair_spindle"):
            browser.evaluate(f"document.querySelector('#gallery button[title={name}]').click()")
        browser.evaluate(AFTER_DRAWING)
        self.assertEqual(browser.evaluate("[...document.querySelectorAll('figcaption')].map(c => c.textContent)"),
                         ["chair_four_legged", "chair_spindle"])
        self.assertTrue(browser.evaluate("""document.querySelector('#stage').stage.items.filter(i => i.hatch === 0 && i.opacity === 1).some(
            i => i.colour.equals(new THREE.Color(...i.mesh.colour.slice(0, 3))))"""))
        self.assertEqual(len(set(browser.evaluate("""document.querySelector('#stage').stage.items.filter(
            i => /seat/.test(i.node.name)).map(i => JSON.stringify(i.colour))"""))), 1)
        browser.click(*self.place_of(0, "front_left_leg"))
        self.assertEqual((self.lit(0), self.lit(1)), (["front_left_leg"], ["turned_leg_a"]))

    def test_a_pair_that_is_not_stored_is_explained(self):
        with open(pages["collection"], encoding="utf-8") as file:
            text = file.read()
        begin = text.index('id="maps">') + len('id="maps">')
        pages["without_maps"] = pages["collection"].replace(".html", "_bare.html")
        with open(pages["without_maps"], "w", encoding="utf-8") as file:
            end = text.index("</script>", begin)
            file.write(text[:begin] + json.dumps({**json.loads(text[begin:end]), "maps": {}}) + text[end:])
        self.open("without_maps")
        for i in (0, 1):
            browser.evaluate(f"document.querySelectorAll('#gallery button')[{i}].click()")
        self.assertRegex(browser.evaluate("document.querySelector('#told code').textContent"),
                         r"^shape_correspondence match \S*chair_four_legged \S*chair_spindle --html match.html$")
        del pages["without_maps"]

    def test_parts_and_graph_light_what_is_pointed_at(self):
        self.open("graph")
        browser.click(*self.place_of(0, "saddle_seat"))
        self.assertEqual(self.lit(0), [])  # surfaces are faint over curves and sheets
        self.assertIn("touches ", browser.evaluate("document.querySelector('#tip').innerText"))
        self.assertEqual(browser.evaluate("document.querySelectorAll('tr.lit').length"), 1)
        self.open("parts")
        browser.evaluate("document.querySelector('#gallery button[title=stool]').click()")
        browser.evaluate(AFTER_DRAWING)
        browser.click(*self.place_of(0, "pad"))
        self.assertEqual(self.lit(0), ["pad"])

    def test_names_are_text(self):
        evil = "</script><script>document.title='broken'</script><img src=x onerror=\"document.title='broken'\">"
        folder = os.path.join(setUpModule.folder.name, "evil")
        os.makedirs(folder)
        graph = os.path.join(folder, "evil.json")
        subprocess.run([arguments.program, "graph", os.path.join(arguments.data, "stool"), "-o", graph, "--quiet"], check=True)
        with open(graph, encoding="utf-8") as file:
            text = file.read()
        with open(graph, "w", encoding="utf-8") as file:
            file.write(text.replace('"pad"', json.dumps(evil)).replace('"name": "stool"', '"name": ' + json.dumps(evil)))
        pages["evil"] = os.path.join(folder, "evil.html")
        subprocess.run([arguments.program, "match", graph, graph, "--html", pages["evil"], "--quiet"], check=True)
        self.open("evil")
        self.assertEqual(browser.evaluate("document.title"), f"{evil} and {evil}")
        self.assertEqual(browser.evaluate("document.querySelectorAll('img').length"), 0)
        self.assertTrue(browser.evaluate(f"[...document.querySelectorAll('td')].some(cell => cell.title.includes({json.dumps(evil)}))"))
        del pages["evil"]

    def test_the_first_lines_say_how_sure_and_of_how_much(self):
        self.open("match")
        self.assertRegex(browser.evaluate("document.querySelector('#facts').textContent"),
                         r"The program is \d+\s% sure of this on average, and least of [a-z ]+, \d+\s%\. (Grey parts have no counterpart: \d+ of .*\d\s% of its surface|Every part has a counterpart)")
        self.assertIn("chair_four_legged → chair_spindle", browser.evaluate("[...document.querySelectorAll('th')].map(cell => cell.textContent)"))

    def test_a_page_is_small(self):
        self.assertLess(os.path.getsize(pages["match"]), LARGEST_PAGE)
        self.open("match")
        self.assertLess(browser.evaluate("document.querySelector('script:not([type])').textContent.length"), LARGEST_SCRIPT)

    def test_modules(self):
        errors, _ = browser.open(os.path.join(HERE, "test_modules.html"))
        self.assertEqual(errors, [])
        browser.wait_for("window.checks")
        self.assertEqual(browser.evaluate("window.failures"), [])
        self.assertGreater(browser.evaluate("window.checks"), 25)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("data")
    parser.add_argument("--screenshots", metavar="FOLDER", help="keep pictures of the pages here")
    arguments, rest = parser.parse_known_args()
    if not chromium.find():
        print("skipped: there is no Chromium")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *rest])
