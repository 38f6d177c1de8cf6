# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small still pictures of shapes, for notebooks."""

import base64
import struct
import zlib
from typing import List, Sequence, Tuple

import numpy as np

MOST_TRIANGLES = 1500  # limit for the triangles of a drawn shape

_YAW, _PITCH = 0.5, 0.3  # angles of the camera, in radians
_SAMPLES_A_PIXEL = 6.0
_FINER = 2  # drawn pixels along a side of each pixel of the result
_LIGHT = np.array([0.35, 0.6, 0.72])  # direction, in the camera's frame

Parts = Sequence[Tuple[np.ndarray, str]]  #: by part: the corners of its triangles (3n, 3), and its colour as #rrggbb


def _turned(corners: np.ndarray) -> np.ndarray:
    """Points in the camera's frame: x to the right, y up, z to the eye."""
    (c, s), (cp, sp) = ((np.cos(a), np.sin(a)) for a in (_YAW, _PITCH))
    around = corners @ np.array([[c, 0, -s], [0, 1, 0], [s, 0, c]]).T
    return around @ np.array([[1, 0, 0], [0, cp, -sp], [0, sp, cp]]).T


def _samples(triangles: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Points that are spread over triangles in pixels, and the triangle of each."""
    u, v = triangles[:, 1, :2] - triangles[:, 0, :2], triangles[:, 2, :2] - triangles[:, 0, :2]
    counts = 2 + np.ceil(_SAMPLES_A_PIXEL * np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2).astype(int)
    of = np.repeat(np.arange(len(triangles)), counts)
    number = np.arange(len(of)) + 1.0
    a, b = number * 0.7548776662466927 % 1, number * 0.5698402909980532 % 1  # a sequence that fills a square evenly
    outside = a + b > 1
    a, b = np.where(outside, 1 - a, a)[:, None], np.where(outside, 1 - b, b)[:, None]
    corners = triangles[of]
    return (1 - a - b) * corners[:, 0] + a * corners[:, 1] + b * corners[:, 2], of


def _drawn(parts: Parts, width: int, height: int) -> np.ndarray:
    """The pixels (height, width, 3) of a shape."""
    size = np.array([width, height]) * _FINER
    pixels = np.full((size[1], size[0], 3), 255.0)
    known = [(corners, colour) for corners, colour in parts if len(corners)]
    if known:
        points = _turned(np.concatenate([corners for corners, _ in known]))
        low, high = points.min(axis=0), points.max(axis=0)
        scale = 0.94 * np.min(size / np.maximum(high[:2] - low[:2], 1e-12))
        points = (points - (low + high) / 2) * [scale, -scale, scale] + [*size / 2, 0]
        triangles = points.reshape(-1, 3, 3)
        colours = np.repeat([[int(colour[k:k + 2], 16) for k in (1, 3, 5)] for _, colour in known],
                            [len(corners) // 3 for corners, _ in known], axis=0)
        normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]) * [1, -1, 1]
        normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-12)[:, None]
        shades = 0.6 + 0.4 * np.abs(normals @ _LIGHT)
        places, of = _samples(triangles)
        x, y = (np.clip(places[:, k].astype(int), 0, size[k] - 1) for k in (0, 1))
        nearest = np.argsort(places[:, 2], kind="stable")  # later ones, which are nearer, stay
        pixels[y[nearest], x[nearest]] = (colours * shades[:, None])[of[nearest]]
    return pixels.reshape(height, _FINER, width, _FINER, 3).mean(axis=(1, 3))


def picture(shapes: Sequence[Parts], width: int = 300, height: int = 300) -> str:
    """Shapes side by side, as an element of HTML that holds a PNG."""
    pixels = np.concatenate([_drawn(parts, width, height) for parts in shapes], axis=1).round().astype(np.uint8)
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    chunks: List[bytes] = []
    header = struct.pack(">IIBBBBB", pixels.shape[1], pixels.shape[0], 8, 2, 0, 0, 0)
    for kind, data in ((b"IHDR", header), (b"IDAT", zlib.compress(rows, 9)), (b"IEND", b"")):
        chunks.append(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)))
    png = base64.b64encode(b"\x89PNG\r\n\x1a\n" + b"".join(chunks)).decode()
    return f'<img src="data:image/png;base64,{png}" alt="{len(shapes)} shapes">'
