#!/usr/bin/env python3
# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Unpacks the zip for Windows and uses the program in it, under wine, as people do; and compares it with a program for Linux.

  test_zip.py FILE.zip PROGRAM DATA

Ends with status 77, which ctest counts as skipped, where there is no wine.
"""
import json
import os
import re
import shutil
import stat
import subprocess
import sys
import tempfile
import unittest
import zipfile

NAME = "shape_correspondence"
WINE = shutil.which("wine")
FOREIGN = "Stühle 椅子 🪑"  # no code page has all these characters
SECONDS = 300
TIMES = re.compile(rb'"seconds":.*')
archive, linux, data = None, None, None


class Zip(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.home = os.path.join(cls.scratch.name, FOREIGN)
        with zipfile.ZipFile(archive) as stream:
            stream.extractall(cls.home)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def setUp(self):
        self.folder = tempfile.mkdtemp(dir=self.home)

    def path(self, name):
        return os.path.join(self.folder, name)

    def read(self, name):
        with open(self.path(name), "rb") as stream:
            return stream.read()

    def write(self, name, content):
        with open(self.path(name), "wb") as stream:
            stream.write(content)
        return name

    def start(self, *words):
        program = os.path.join(self.home, NAME, NAME + ".exe")
        return subprocess.Popen([WINE, program, *words], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE)

    def run_it(self, *words, status=0):
        """Runs the program. Returns its standard output or, if `status` is not 0, its standard error."""
        process = self.start(*words)
        out, error = process.communicate(timeout=SECONDS)
        self.assertEqual(process.returncode, status, error.decode())
        return error.decode() if status else out

    def names(self):
        return sorted(os.listdir(self.folder))

    def test_demo(self):
        printed = self.run_it("demo").decode()
        self.assertIn("deformation energy", printed)
        self.assertEqual(sorted(os.listdir(self.path(NAME + "_demo"))), ["blend.glb", "blend.html", "match.html", "match.json"])
        self.run_it("demo")  # overwrites the files of the first run

    def test_same_bytes_as_on_linux(self):
        # Pages and pictures of curves are left out: sines of the C libraries differ in their last bits
        models = ["models/table_trestle", "models/table_pedestal"]
        commands = [["match", *models, "-o", "match.json"], ["blend", *models, "-o", "blend.glb"],
                    ["blend", *models, "--at", "0.5", "-o", "half.glb"], ["graph", "half.glb", "-o", "half.json"],
                    ["graph", models[0], "-o", "graph.json", "-o", "graph.graphml", "-o", "graph.dot"],
                    ["transfer", *models, "--labels", "parts", "-o", "labels.ply"]]
        os.symlink(data, self.path("models"))
        for words in commands:
            self.assertNotIn(b"\r", self.run_it(*words))
        ours = {name: self.read(name) for name in self.names() if name != "models"}
        self.assertGreater(len(ours), len(commands))
        for words in commands:
            subprocess.run([linux, *words], cwd=self.folder, check=True, capture_output=True)
        for name, content in ours.items():
            with self.subTest(name):
                self.assertEqual(TIMES.sub(b"", content), TIMES.sub(b"", self.read(name)))
        self.assertEqual(self.run_it("graph", models[0], "--json", "-"), ours["graph.json"])

    def test_names_of_other_alphabets(self):
        with open(os.path.join(data, "raw", "chair_swivel.obj"), "rb") as stream:
            model = stream.read()
        name = FOREIGN + ".obj"
        self.write(name, "o Прямоугольник\n".encode() + model.replace(b"\n", b"\r\n"))
        printed = self.run_it("graph", name, "-o", "größe.json", "-o", "größe.html", "--cache", "zwischen/größe").decode()
        self.assertIn(name, printed)
        self.assertLessEqual({"größe.json", "größe.html", name, "zwischen"}, set(self.names()))
        self.assertNotIn(b"\r\n", self.read("größe.json"))
        self.assertIn("fehlt_ä.obj: there is no such file", self.run_it("graph", "fehlt_ä.obj", status=1))
        self.assertIn("there is no option '--größe'", self.run_it("graph", name, "--größe", status=2))

    def test_outputs_are_whole_or_not_there(self):
        self.write("old.json", b"old")
        chair = os.path.join(self.home, NAME, "data", "chair_swivel")
        self.run_it("graph", chair, "-o", "old.json", "-q")
        self.assertEqual(json.loads(self.read("old.json"))["name"], "chair_swivel")
        before = self.names()
        os.chmod(self.path(self.write("kept.json", b"kept")), stat.S_IREAD)
        self.assertIn("it cannot be written", self.run_it("graph", chair, "-o", "kept.json", status=1))
        self.assertEqual(self.read("kept.json"), b"kept")
        self.assertIn("it is a folder", self.run_it("graph", chair, "--json", ".", status=1))
        self.assertIn("it cannot be written", self.run_it("graph", chair, "-o", "no/such/folder.json", status=1))
        self.assertIn("the same file", self.run_it("graph", chair, "--json", "ä.x", "--dot", "Ä.X", status=2))
        self.assertEqual(self.names(), sorted(before + ["kept.json"]))
        os.mkdir(self.path("frames"))
        other = os.path.join(self.home, NAME, "data", "chair_four_legged")
        self.run_it("blend", chair, other, "--frames", "2", "-o", "frames\\", "-q")
        self.assertEqual(len(os.listdir(self.path("frames"))), 2)

    def test_other_formats(self):
        self.write("model.dae", b"<COLLADA/>")
        self.assertIn("save the model as GLB", self.run_it("graph", "model.dae", status=1))

    def test_sets_and_what_is_kept_of_them(self):
        tables = [os.path.join(data, name) for name in ("table_trestle", "table_pedestal", "table_four_legged")]
        words = ("collection", *tables, "--store", "store", "-q", "--json")
        at_once = [self.start(*words, f"set_{i}.json") for i in range(3)]
        for process in at_once:
            _, error = process.communicate(timeout=SECONDS)
            self.assertEqual(process.returncode, 0, error.decode())
        self.run_it(*words, "again.json")
        for i in range(3):
            self.assertEqual(self.read(f"set_{i}.json"), self.read("again.json"))
        self.assertFalse([name for name in os.listdir(self.path("store")) if ".tmp-" in name])
        killed = self.start(*words[:-4], "--store", "other", "-q", "--json", "set.json")
        killed.kill()
        killed.communicate()
        self.run_it("collection", *tables, "--store", "other", "-q", "--json", "other.json")
        self.assertEqual(self.read("other.json"), self.read("again.json"))

    def test_any_number_of_threads(self):
        chair = os.path.join(self.home, NAME, "data", "chair_swivel")
        for threads in ("1", "3"):
            self.run_it("graph", chair, "--threads", threads, "--json", threads + ".json", "-q")
        self.assertEqual(self.read("1.json"), self.read("3.json"))


if __name__ == "__main__":
    if not WINE:
        print("wine is missing")
        sys.exit(77)
    archive, linux, data = map(os.path.abspath, sys.argv[1:4])
    os.environ.update(WINEDEBUG="-all", LC_ALL="C.UTF-8")  # wine encodes names of files as the locale says
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
