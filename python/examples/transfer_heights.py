# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
# Values at the vertices of one chair go to the other along the match: heights, drawn by matplotlib where it is there.
# Models are read by trimesh where it is there, and else by the package.
import sys

import numpy as np

import shape_correspondence as sc


def parts_of(path):
    try:
        import trimesh
    except ImportError:
        return [tuple(part) for part in sc.read(path).parts]
    scene = trimesh.load(path, force="scene")
    return [(name, mesh.vertices, mesh.faces) for name, mesh in scene.geometry.items()]


def draw(shapes, values, file):
    try:
        import matplotlib
    except ImportError:
        return
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure = plt.figure(figsize=(8, 4))
    for i, (parts, of_parts) in enumerate(zip(shapes, values)):
        axes = figure.add_subplot(1, 2, i + 1, projection="3d")
        points = np.concatenate([vertices for _, vertices, _ in parts])
        axes.scatter(points[:, 0], -points[:, 2], points[:, 1], c=np.concatenate(of_parts), s=1)
        axes.set_box_aspect(np.ptp(points[:, [0, 2, 1]], axis=0))
    figure.savefig(file)


def main(source_path, target_path):
    source, target = parts_of(source_path), parts_of(target_path)
    match = sc.match(sc.Shape(source, "source"), sc.Shape(target, "target"))
    heights = [vertices[:, 1] for _, vertices, _ in source]
    moved = sc.transfer(match, heights)
    for name, vertices, _ in target:
        if not np.isnan(moved[name]).any():
            print(f"{name}: its heights {np.ptp(vertices[:, 1]):.2f} are {np.ptp(moved[name]):.2f} on the source")
    draw((source, target), (heights, [moved[name] for name, _, _ in target]), "heights.png")


if __name__ == "__main__":
    main(*(sys.argv[1:] or ("data/chair_four_legged", "data/chair_slatted")))
