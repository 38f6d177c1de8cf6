# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the add-on without a window.

  blender -b --factory-startup --python-exit-code 3 --python test_addon.py -- FOLDER_OF_MODULE DATA [PICTURES]

With a folder of pictures, it also renders those of the manual.
"""

import math
import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix

MODULE, DATA, *PICTURES = map(Path, sys.argv[sys.argv.index("--") + 1:])
sys.path.insert(0, str(Path(__file__).parent))
import shape_correspondence_parts as addon  # noqa: E402

addon.register()
SCENE, SETTINGS = bpy.context.scene, bpy.context.scene.parts


def refused(operator, word):
    try:
        operator()
    except RuntimeError as error:
        assert word in str(error), error
    else:
        raise AssertionError(word)


def clear():
    for things in (bpy.data.objects, bpy.data.collections, bpy.data.meshes):
        for thing in list(things):
            things.remove(thing)
    SETTINGS.pairs.clear()
    addon.last_match.clear()


def load(side, name):
    """A shape of data/ as a collection."""
    collection = addon.new_collection(name, bpy.context)
    parts = sc.read(DATA / name).parts
    of_names = {}
    for part in parts:
        thing = addon.new_object(part.name, part.vertices, part.faces, collection)
        of_names[thing.name] = part.name
    setattr(SETTINGS, f"{side}_collection", collection)
    return of_names


def listed():
    return {(pair.source, pair.target) for pair in SETTINGS.pairs}


# Messages say what to do
refused(bpy.ops.parts.match, "Choose the source")
clear()
if "shape_correspondence" not in sys.modules:
    sys.path.append(str(MODULE))
sc = addon.core()

# The pairs are those of files
for source, target in (("chair_four_legged", "chair_swivel"), ("table_pedestal", "table_trestle"),
                       ("airplane_propeller", "airplane_twin_engine")):
    clear()
    names = load("source", source), load("target", target)
    assert bpy.ops.parts.match() == {"FINISHED"}
    expected = sc.match(DATA / source, DATA / target).pairs
    assert {(names[0][a], names[1][b]) for a, b in listed()} == set(expected), (source, target)

# Colours are by block
clear()
names = load("source", "chair_four_legged"), load("target", "chair_swivel")
bpy.ops.parts.match()
match = addon.matched(bpy.context)
for block in match.blocks:
    assert len({tuple(bpy.data.objects[name].color) for name in [*block.source, *block.target]}) == 1
assert len({tuple(thing.color) for thing in bpy.data.objects}) >= len(match.blocks)

# A pair that is clicked is selected; it can be forbidden, and others pinned
SETTINGS.index = 0
pair = SETTINGS.pairs[0]
assert {thing.name for thing in bpy.context.selected_objects} == {pair.source, pair.target}
first = pair.source, pair.target
bpy.ops.parts.state(index=0, state="FORBIDDEN")
bpy.ops.parts.match()
assert first not in addon.matched(bpy.context).pairs and first in listed()
bpy.ops.parts.state(index=[(p.source, p.target) for p in SETTINGS.pairs].index(first), state="FORBIDDEN")
bpy.ops.parts.pin_selected()
bpy.ops.parts.match()
assert first in addon.matched(bpy.context).pairs
bpy.ops.object.select_all(action="DESELECT")
refused(bpy.ops.parts.pin_selected, "Select one object")

# Axes, also of a mirrored object
leg = bpy.data.objects[match.blocks[0].source[0]]
leg.matrix_world = Matrix(((-2, 0, 0, 1), (0, 1, 0, 2), (0, 0, 1, 3), (0, 0, 0, 1)))
bpy.context.view_layer.update()
_, points, faces = addon.part_of(leg, bpy.context)
x, y, z = leg.data.vertices[0].co
np.testing.assert_allclose(points[0], (1 - 2 * x, z + 3, -(y + 2)), atol=1e-6)
leg.data.calc_loop_triangles()
assert list(faces[0]) == list(leg.data.loop_triangles[0].vertices)[::-1]
leg.matrix_world = Matrix()
bpy.context.view_layer.update()

# Labels
bpy.ops.parts.label()
for side in ("source", "target"):
    for name, role in getattr(addon.matched(bpy.context).roles, side).items():
        thing = bpy.data.objects[name]
        assert thing.vertex_groups[role].weight(len(thing.data.vertices) - 1) == 1

# The blend is that of the module at every frame
SETTINGS.frame_start, SETTINGS.frame_end = 11, 10
refused(bpy.ops.parts.blend, "after the first")
SETTINGS.frame_end = 21
bpy.ops.parts.blend()
blend = sc.blend(None, None, addon.matched(bpy.context))


def visible():
    return [thing for thing in bpy.data.collections["Blend"].objects if not thing.hide_render]


for frame in range(11, 22):
    SCENE.frame_set(frame)
    thing, = visible()
    assert not thing.hide_viewport
    _, points, faces = addon.part_of(thing, bpy.context)
    parts = blend((frame - 11) / 10).parts
    expected = np.concatenate([part.vertices for part in parts])
    assert len(faces) == sum(len(part.faces) for part in parts)
    assert np.abs(points - expected).max() <= 1e-7 * np.abs(expected).max(), frame
runs = bpy.data.collections["Blend"].objects
assert all(len(thing.data.materials) > 3 for thing in runs)
assert sum(len(thing.data.shape_keys.key_blocks) if thing.data.shape_keys else 1 for thing in runs) == 11

# A single mesh is divided into parts
joined = [addon.part_of(thing, bpy.context) for thing in addon.chosen("source", bpy.context)]
clear()
offsets = np.cumsum([0, *(len(vertices) for _, vertices, _ in joined)])
single = addon.new_object("chair", np.concatenate([vertices for _, vertices, _ in joined]),
                          np.concatenate([faces + offset for (_, _, faces), offset in zip(joined, offsets)]),
                          SCENE.collection)
SETTINGS.source_object = single
load("target", "chair_swivel")
bpy.ops.parts.match()
assert SETTINGS.source_collection.name == "chair parts" and len(SETTINGS.source_collection.objects) > 3 and listed()
assert single.hide_render


def render(name):
    """A picture of what is there, by Cycles."""
    corners = np.concatenate([addon.to_blender(addon.part_of(thing, bpy.context)[1]) for thing in bpy.data.objects
                              if thing.type == "MESH" and not thing.hide_render])
    low, high = corners.min(0), corners.max(0)
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.type, camera.data.ortho_scale = "ORTHO", 1.1 * max(high[0] - low[0], 2 * (high[2] - low[2]))
    camera.location = (low + high) / 2 + np.array((0.25, -1, 0.3)) * 10
    camera.rotation_euler = (math.pi / 2 - math.atan2(0.3, 1.03), 0, math.atan2(0.25, 1))
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.data.energy, sun.data.angle, sun.rotation_euler = 2, 0.3, (0.7, 0.2, 0.5)
    for thing in (camera, sun):
        SCENE.collection.objects.link(thing)
    SCENE.camera = camera
    SCENE.world = SCENE.world or bpy.data.worlds.new("World")
    SCENE.world.use_nodes = True
    SCENE.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.45, 0.45, 0.45, 1)
    SCENE.render.film_transparent = True
    SCENE.render.engine, SCENE.cycles.samples, SCENE.cycles.use_denoising = "CYCLES", 128, False
    SCENE.render.resolution_x, SCENE.render.resolution_y, SCENE.render.resolution_percentage = 960, 480, 100
    SCENE.view_settings.view_transform = "Standard"
    SCENE.render.filepath = str(PICTURES[0] / name)
    SCENE.render.image_settings.color_mode = "RGBA"
    SCENE.render.image_settings.compression = 100
    bpy.ops.render.render(write_still=True)
    picture = bpy.data.images.load(SCENE.render.filepath)
    pixels = np.array(picture.pixels).reshape(-1, 4)
    on_white = pixels[:, :3] * pixels[:, 3:] + 1 - pixels[:, 3:]
    pixels[:, :3], pixels[:, 3] = np.round(on_white * 31) / 31, 1  # fewer colours make a smaller file
    picture.pixels[:] = pixels.ravel()
    picture.save()
    for thing in (camera, sun):
        bpy.data.objects.remove(thing)


if PICTURES:
    bpy.ops.preferences.addon_enable(module="cycles")
    clear()
    load("source", "chair_four_legged"), load("target", "chair_swivel")
    bpy.ops.parts.match()
    SETTINGS.frame_start, SETTINGS.frame_end = 1, 5
    bpy.ops.parts.blend()
    for thing in SETTINGS.source_collection.objects:
        thing.location.x -= 1.1
    for thing in SETTINGS.target_collection.objects:
        thing.location.x += 1.1
    for side in ("source", "target"):
        for thing in addon.chosen(side, bpy.context):
            thing.data.materials.append(addon.material(tuple(thing.color)))
    bpy.context.view_layer.update()
    for thing in bpy.data.collections["Blend"].objects:
        thing.hide_render = True
    SCENE.frame_set(3)
    render("blender.png")
print("tested")
