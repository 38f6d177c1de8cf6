#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""test_structure_graph.py CONVERTER PROGRAM: structure graphs in XML become graphs that the program reads."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

CONVERTER, PROGRAM = sys.argv[1:3]
POINT = "<point>{} {} {}</point>".format


def leg(name, x, y):
    return f"<node><id>{name}</id><type>CURVE</type>{''.join(POINT(x, y, z) for z in (0, 0.3, 0.6, 0.9))}</node>"


TOP = ("<node><id>top</id><type>Sheet</type><controls><c>2</c><c>3</c></controls>"
       + "".join(POINT(x, y, 0.9) for x in (-1, 1) for y in (-0.5, 0, 0.5)) + "<weights>1 1 1 1 1 1 </weights></node>")
EDGES = ("<edge><n>top</n><n>a</n><coord><uv>1 1 0 0</uv></coord><coord><uv>1 0 0 0</uv></coord></edge>"
         + "".join(f"<edge><n>top</n><n>{name}</n></edge>" for name in "bcd"))
TABLE = TOP + leg("a", 1, 0.5) + leg("b", -1, 0.5) + leg("c", 1, -0.5) + leg("d", -1, -0.5) + EDGES
BOW = "<node><id>bow</id><type>CURVE</type>" + POINT(0, 0, 0) + POINT(0, 0, 8) + POINT(8, 0, 8) + POINT(8, 0, 0) + "</node>"


class Structure_graphs(unittest.TestCase):
    def converted(self, body, status=0):
        """The graph that the converter writes, and the same as the program writes it; or the error, if `status` is not 0."""
        with tempfile.TemporaryDirectory() as folder:
            source, target = (os.path.join(folder, "g." + ending) for ending in ("xml", "json"))
            with open(source, "w", encoding="utf-8") as file:
                file.write(f'<?xml version="1.0"?><document>{body}</document>')
            done = subprocess.run([sys.executable, CONVERTER, source, target], capture_output=True, text=True)
            self.assertEqual(done.returncode, status, done.stderr)
            if status:
                return done.stderr
            read = subprocess.run([PROGRAM, "graph", target, "--json", "-", "--quiet"], check=True, capture_output=True, text=True)
            with open(target, encoding="utf-8") as file:
                return json.load(file), json.loads(read.stdout)

    def test_a_table(self):
        graph, read = self.converted(TABLE)
        self.assertEqual(graph["parts"][0]["grid"][4][4], [0, 0, 0.9])
        self.assertEqual(graph["contacts"][0]["parameters"], [[1, 1], [1]])
        self.assertEqual(graph["contacts"][1]["parameters"], [[0, 1], [1]])  # without coordinates, a contact is where the parts are nearest
        self.assertAlmostEqual(read["up"][2], 1)
        self.assertEqual(len(read["groups"]), 2)  # the top, and the legs, which are detected as a group

    def test_groups(self):
        _, read = self.converted(TABLE + "<group><n>a</n><n>b</n></group><group><n>c</n><n>d</n></group>")
        self.assertEqual([group["symmetry"] for group in read["groups"]], ["reflection", "reflection", "self"])
        graph, _ = self.converted(TABLE + "<group><n>a</n><n>b</n><n>c</n><n>d</n></group>")
        self.assertNotIn("groups", graph)  # the group is neither a mirror pair nor a row, so groups are detected

    def test_curves_are_cubic_b_splines(self):
        graph, _ = self.converted(TABLE + BOW + "<edge><n>bow</n><n>a</n></edge>")
        points = graph["parts"][5]["points"]  # four control points are a Bézier curve: its middle is (p + 3 q + 3 r + s) / 8
        self.assertEqual([points[0], points[16], points[32]], [[0, 0, 0], [4, 0, 6], [8, 0, 0]])

    def test_complaints(self):
        for old, new, words in (("<id>b</id>", "<id>a</id>", "two of one <id>"), ("<type>Sheet", "<type>Blob", "BLOB"), ("<c>3</c>", "<c>4</c>", "<controls>"),
                                ("<n>b</n>", "<n>x</n>", "'x'"), ("1 1 1 1 1 1", "1 1", "weights"), ("<point>1 0.5 0<", "<point>1 0.5<", "three numbers")):
            self.assertIn(words, self.converted(TABLE.replace(old, new, 1), 1))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
