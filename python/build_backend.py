# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The build backend of `pip install .` (PEP 517): CMake builds the module, and this packs it into a wheel.

Needs nothing but Python's own library. Settings: ``--config-settings cmake-args="-DNAME=VALUE ..."`` goes to CMake;
``--config-settings build-dir=FOLDER`` takes the module from a folder where CMake has built it.
"""

import base64
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NAME = "shape_correspondence"
LICENCE = "LICENSE"
SOURCES = ["CMakeLists.txt", "CMakePresets.json", LICENCE, "README.md", "pyproject.toml", "cmake", "data", "doc",
           "examples", "include", "package_info", "python", "src"]


def version():
    """The version of the project, which CMakeLists.txt tells."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(Shape_correspondence VERSION ([0-9.]+)", text).group(1)


def metadata():
    """The metadata of the wheel, as pyproject.toml states it."""
    project = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    readme = (ROOT / "README.md").read_text(encoding="utf-8")

    def text(key):
        return re.search(f'^{key} = .*?"(.*?)"', project, re.MULTILINE).group(1)

    def texts(key):
        return re.findall('"(.*?)"', re.search(rf"^{key} = \[(.*?)\]", project, re.MULTILINE | re.DOTALL).group(1))

    lines = ["Metadata-Version: 2.1", f"Name: {NAME}", f"Version: {version()}", f"Summary: {text('description')}",
             f"Author: {text('authors')}", f"License: {text('license')}", f"Keywords: {','.join(texts('keywords'))}",
             *(f"Classifier: {name}" for name in texts("classifiers")), f"Requires-Python: {text('requires-python')}",
             *(f"Requires-Dist: {name}" for name in texts("dependencies"))]
    for extra in ("trimesh", "pyvista"):
        lines += [f"Provides-Extra: {extra}", f'Requires-Dist: {texts(extra)[0]}; extra == "{extra}"']
    return "\n".join([*lines, "Description-Content-Type: text/markdown", "", readme])


def tag():
    """The Python and the platform that the wheel is for."""
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return f"{python}-{python}-{platform}"


def build(folder, settings):
    """Builds the module in `folder`."""
    configure = ["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DSHAPE_CORRESPONDENCE_PYTHON=ON",
                 "-DBUILD_TESTING=OFF", "-DSHAPE_CORRESPONDENCE_EXAMPLES=OFF", f"-DPython3_EXECUTABLE={sys.executable}"]
    if shutil.which("ninja"):
        configure += ["-G", "Ninja"]
    subprocess.run(configure + shlex.split(settings.get("cmake-args", "")), check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "shape_correspondence_python", "--parallel",
                    str(os.cpu_count() or 1)], check=True)


def install(folder, files):
    """Installs the module of the build folder `folder` into `files`."""
    with tempfile.TemporaryDirectory() as prefix:
        subprocess.run(["cmake", "--install", folder, "--component", "python", "--strip", "--prefix", prefix], check=True)
        package, = Path(prefix).rglob(f"{NAME}/__init__.py")
        shutil.copytree(package.parent, files / NAME)


def write_info(folder):
    """Writes the folder of metadata. Returns its name."""
    info = Path(folder) / f"{NAME}-{version()}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(metadata(), encoding="utf-8")
    (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: {NAME}\nRoot-Is-Purelib: false\nTag: {tag()}\n")
    shutil.copy(ROOT / LICENCE, info)
    return info.name


def write_record(folder, info):
    """Writes the list of all files of the wheel, with their digests."""
    record = folder / info / "RECORD"
    lines = []
    for path in sorted(p for p in folder.rglob("*") if p.is_file()):
        digest = base64.urlsafe_b64encode(hashlib.sha256(path.read_bytes()).digest()).rstrip(b"=").decode()
        lines.append(f"{path.relative_to(folder).as_posix()},sha256={digest},{path.stat().st_size}\n")
    record.write_text("".join(lines) + f"{info}/RECORD,,\n")


def get_requires_for_build_wheel(config_settings=None):
    """Nothing that pip could install: CMake, a compiler and the libraries come from the system."""
    return []


get_requires_for_build_sdist = get_requires_for_build_wheel


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """The metadata alone, without a build."""
    return write_info(metadata_directory)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Builds the wheel. Returns its name."""
    settings = config_settings or {}
    name = f"{NAME}-{version()}-{tag()}.whl"
    with tempfile.TemporaryDirectory() as temporary:
        files = Path(temporary) / "files"
        files.mkdir()
        folder = settings.get("build-dir")
        if folder is None:
            folder = str(Path(temporary) / "build")
            build(folder, settings)
        install(folder, files)
        write_record(files, write_info(files))
        with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
            for path in sorted(p for p in files.rglob("*") if p.is_file()):
                wheel.write(path, path.relative_to(files).as_posix())
    return name


def build_sdist(sdist_directory, config_settings=None):
    """Packs the sources that the module is built from. Returns the name of the archive."""
    base = f"{NAME}-{version()}"

    def is_source(entry):
        return None if "__pycache__" in entry.name or entry.name.endswith(".pyc") else entry

    with tempfile.TemporaryDirectory() as temporary:
        info = Path(temporary) / "PKG-INFO"
        info.write_text(metadata(), encoding="utf-8")
        with tarfile.open(Path(sdist_directory) / f"{base}.tar.gz", "w:gz") as archive:
            for source in SOURCES:
                archive.add(ROOT / source, f"{base}/{source}", filter=is_source)
            archive.add(info, f"{base}/PKG-INFO")
    return f"{base}.tar.gz"
