# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The module as pip installs it, its examples, and its build backend."""

import importlib.util
import os
import re
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

import shape_correspondence as sc

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "python" / "examples"


@pytest.fixture(scope="module")
def backend():
    spec = importlib.util.spec_from_file_location("build_backend", ROOT / "python" / "build_backend.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def run_python(*arguments, cwd, python=sys.executable, **environment):
    return subprocess.run([python, *map(str, arguments)], cwd=cwd, capture_output=True, text=True,
                          env={**os.environ, **environment})


@pytest.fixture
def sources(tmp_path):
    """A folder with `data/` where examples may write."""
    (tmp_path / "data").symlink_to(ROOT / "data")
    return tmp_path


def test_pip_installs_the_module(tmp_path, sources):
    build = os.environ.get("SHAPE_CORRESPONDENCE_BUILD_DIR")
    if build is None:
        pytest.skip("SHAPE_CORRESPONDENCE_BUILD_DIR does not name the build folder")
    made = run_python("-m", "venv", "--system-site-packages", tmp_path / "env", cwd=ROOT)
    if made.returncode != 0:
        pytest.skip("there is no venv")
    python = tmp_path / "env" / "bin" / "python"
    pip = run_python("-m", "pip", "install", "--no-build-isolation", "--no-index", "--config-settings",
                     f"build-dir={build}", ROOT, cwd=tmp_path, python=python, PYTHONPATH="")
    assert pip.returncode == 0, pip.stdout + pip.stderr
    result = run_python(EXAMPLES / "match_two_chairs.py", cwd=sources, python=python, PYTHONPATH="")
    assert result.returncode == 0, result.stderr
    assert "seat -> rush_seat" in result.stdout
    assert (sources / "match.html").exists() and (sources / "half_way.obj").exists()
    where = run_python("-c", "import shape_correspondence; print(shape_correspondence.__file__)", cwd=sources,
                       python=python, PYTHONPATH="")
    assert str(tmp_path / "env") in where.stdout


def test_make_wheel(tmp_path):
    pytest.importorskip("ensurepip", reason="there is no venv")
    build = os.environ.get("SHAPE_CORRESPONDENCE_BUILD_DIR")
    if build is None:
        pytest.skip("SHAPE_CORRESPONDENCE_BUILD_DIR does not name the build folder")
    made = subprocess.run([ROOT / "scripts" / "make_wheel", "--build", build], capture_output=True, text=True,
                          env={**os.environ, "WHEELS": str(tmp_path), "PYTHON": sys.executable})
    assert made.returncode == 0, made.stdout + made.stderr
    assert f"shape_correspondence {sc.__version__} knows roles of" in made.stdout and list(tmp_path.glob("*.whl"))


def test_version(backend):
    assert backend.version() == sc.__version__
    assert f"Version: {sc.__version__}\n" in backend.metadata()


def test_metadata_is_that_of_pyproject(backend, tmp_path):
    project = (ROOT / "pyproject.toml").read_text()
    for key, name in (("description", "Summary"), ("requires-python", "Requires-Python")):
        value = re.search(f'^{key} = "(.*)"', project, re.MULTILINE).group(1)
        assert f"{name}: {value}\n" in backend.metadata()
    info = tmp_path / backend.prepare_metadata_for_build_wheel(tmp_path)
    assert (info / "METADATA").exists() and (info / "LICENSE").exists()


def test_archive_of_sources(backend, tmp_path):
    with tarfile.open(tmp_path / backend.build_sdist(tmp_path)) as archive:
        names = {name.split("/", 1)[1] for name in archive.getnames() if "/" in name}
    assert {"PKG-INFO", "CMakeLists.txt", "pyproject.toml", "python/build_backend.py", "src/cli/match.cpp"} <= names
    assert not any("__pycache__" in name for name in names)


def test_types_are_shipped():
    folder = Path(sc.__file__).parent
    assert (folder / "py.typed").exists()
    stub = (folder / "_core.pyi").read_text()
    for name, thing in vars(sc._core).items():
        if not name.startswith("__"):
            assert re.search(rf"^(class|def) {name}\b", stub, re.MULTILINE), name
            for member in vars(thing) if isinstance(thing, type) and name != "InvalidInput" else ():
                assert member.startswith("_") or f"    def {member}(" in stub, (name, member)


def test_example_of_values(sources):
    result = run_python(EXAMPLES / "transfer_heights.py", cwd=sources)
    assert result.returncode == 0, result.stderr
    assert "rush_seat: " in result.stdout


def test_notebook():
    pytest.importorskip("matplotlib")
    result = run_python(EXAMPLES / "run_notebook.py", EXAMPLES / "tutorial.ipynb", "--check", cwd=ROOT,
                        MPLBACKEND="Agg")
    assert result.returncode == 0, result.stderr


def test_import_takes_little_time():
    code = "import shape_correspondence, time; print(time.process_time())"
    shares = [float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout) for _ in range(3)]
    assert min(shares) < 0.3  # seconds of processor time; half of it on an idle machine
