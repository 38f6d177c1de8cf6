# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Work is done without Python's lock, reports its progress, and can be interrupted."""

import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import shape_correspondence as sc


def test_progress(data):
    reports = []
    sc.build_graph(data / "table_trestle", progress=lambda share, what: reports.append((share, what)))
    shares = [share for share, _ in reports]
    assert shares == sorted(shares) and shares[-1] == 1
    assert reports[0][1].endswith("table_trestle")


def test_progress_is_called_in_the_calling_thread(table):
    threads = set()
    sc.match(table(), table(), progress=lambda share, what: threads.add(threading.get_ident()))
    assert threads == {threading.get_ident()}


def test_an_exception_of_progress_ends_the_work(data):
    def fail(share, what):
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        sc.build_graph(data / "table_trestle", progress=fail)
    with pytest.raises(KeyError, match="enough"):
        sc.collection([data / "table_trestle", data / "table_pedestal"], progress=fail)


def test_false_ends_a_search(table):
    graphs = [sc.build_graph(table()), sc.build_graph(table())]
    found = sc.match(*graphs, search_method="beam", alignments=0, progress=lambda share, what: share == 0)
    assert found.warnings[-1].startswith("The search was cancelled after 1 of")
    assert found.pairs and not found.complete
    none = sc.match(*graphs, search_method="beam", progress=lambda share, what: False)
    assert none.warnings[-1].startswith("The search was cancelled after 0 of") and not none.pairs


def test_other_threads_run_meanwhile(data):
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.monotonic()
    sc.build_graph(data / "chair_slatted", threads=1)
    seconds = time.monotonic() - begin
    done.set()
    thread.join()
    gaps = [b - a for a, b in zip(ticks, ticks[1:])]
    assert seconds > 0.05  # long enough for many ticks
    assert max(gaps) < seconds / 2


INTERRUPTED = """
import os, signal, sys, threading
import shape_correspondence as sc
began = threading.Event()
def interrupt():
    began.wait(60)
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=interrupt, daemon=True).start()
try:
    sc.build_graph(sys.argv[1], threads=1, progress=lambda share, what: began.set())
    print("finished")
except KeyboardInterrupt:
    print("interrupted")
"""


@pytest.mark.skipif(os.name != "posix", reason="needs signals")
def test_ctrl_c_ends_the_work(data):
    result = subprocess.run([sys.executable, "-c", INTERRUPTED, str(data / "bicycle")], capture_output=True, text=True,
                            timeout=120)
    assert result.stdout == "interrupted\n", result.stderr


def test_errors_of_work_are_raised(data):
    with pytest.raises(sc.InvalidInput, match="README"):
        sc.build_graph(data / "README.md")
