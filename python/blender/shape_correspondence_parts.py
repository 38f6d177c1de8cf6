# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Add-on of Blender: matches the parts of two shapes, blends them, and labels their parts. See the manual."""

import importlib
import os
import sys
import zipfile

import bpy
import numpy as np

bl_info = {
    "name": "Shape Correspondence: Parts",
    "author": "the Shape_correspondence developers",
    "version": (0, 1, 0),
    "blender": (3, 3, 0),
    "location": "3D View > Sidebar > Parts",
    "description": "Matches the parts of two shapes, blends them, and labels their parts",
    "category": "Object",
}

GREY = (0.6, 0.6, 0.6, 1)
last_match = {}  # the last match, by the inputs that it was found from


def core():
    """The Python module: the one in the add-on's zip, that Blender's Python has, or that of the preferences, a folder or a wheel."""
    bundled = os.path.join(os.path.dirname(os.path.abspath(__file__)), "modules")
    if os.path.isdir(os.path.join(bundled, "shape_correspondence")) and bundled not in sys.path:
        sys.path.insert(0, bundled)
    try:
        return importlib.import_module("shape_correspondence")
    except ModuleNotFoundError:
        addon = bpy.context.preferences.addons.get(__name__)
        path = bpy.path.abspath(addon.preferences.module) if addon else ""
        if path.endswith(".whl"):
            folder = bpy.utils.user_resource("SCRIPTS", path=os.path.join("modules", os.path.basename(path)[:-4]),
                                             create=True)
            with zipfile.ZipFile(path) as wheel:
                wheel.extractall(folder)
            path = folder
        if not path:
            raise RuntimeError("The Python module shape_correspondence is not installed; name its folder or its wheel in "
                               "the preferences of the add-on") from None
        sys.path.append(path)
        importlib.invalidate_caches()
        return importlib.import_module("shape_correspondence")


def to_module(points):
    """Points of Blender, where z is up, in the axes of the module, where y is up."""
    return points[:, [0, 2, 1]] * [1, 1, -1]


def to_blender(points):
    return points[:, [0, 2, 1]] * [1, -1, 1]


def mesh_objects(shape):
    """The meshes of a collection, or of an object and its children."""
    every = shape.all_objects if isinstance(shape, bpy.types.Collection) else [shape, *shape.children_recursive]
    return [thing for thing in every if thing.type == "MESH"]


def part_of(thing, context):
    """Name, vertices and triangles of an object as it is in the world, with its modifiers."""
    evaluated = thing.evaluated_get(context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    mesh.calc_loop_triangles()
    vertices, faces = np.empty(3 * len(mesh.vertices)), np.empty(3 * len(mesh.loop_triangles), int)
    mesh.vertices.foreach_get("co", vertices)
    mesh.loop_triangles.foreach_get("vertices", faces)
    evaluated.to_mesh_clear()
    place, faces = np.array(thing.matrix_world), faces.reshape(-1, 3)
    if np.linalg.det(place[:3, :3]) < 0:
        faces = faces[:, ::-1]
    return thing.name, to_module(vertices.reshape(-1, 3) @ place[:3, :3].T + place[:3, 3]), faces


def new_object(name, points, faces, collection):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(to_blender(points).tolist(), [], faces.tolist())
    thing = bpy.data.objects.new(name, mesh)
    collection.objects.link(thing)
    return thing


def new_collection(name, context):
    collection = bpy.data.collections.new(name)
    context.scene.collection.children.link(collection)
    return collection


def divide(thing, context):
    """Divides a mesh into parts, the objects of a new collection, and hides the mesh."""
    name, vertices, faces = part_of(thing, context)
    mesh = type("Mesh", (), {"vertices": vertices, "faces": faces})
    collection = new_collection(f"{name} parts", context)
    for part in core().Shape(mesh, name).parts:
        new_object(part.name.replace("part", name, 1), part.vertices, part.faces, collection)
    thing.hide_set(True)
    thing.hide_render = True
    return collection


def chosen(side, context):
    """The objects of the source or the target."""
    settings = context.scene.parts
    shape = getattr(settings, f"{side}_collection") or getattr(settings, f"{side}_object")
    if shape is None:
        raise RuntimeError(f"Choose the {side}: a collection or an object")
    if isinstance(shape, bpy.types.Object) and len(mesh_objects(shape)) == 1:
        shape = divide(mesh_objects(shape)[0], context)
        setattr(settings, f"{side}_collection", shape)
    return mesh_objects(shape)


def matched(context):
    """The match of both shapes; it is found anew if they, or pinned and forbidden pairs, have changed."""
    shapes = [[part_of(thing, context) for thing in chosen(side, context)] for side in ("source", "target")]
    names = [{name for name, _, _ in shape} for shape in shapes]
    wanted = {state: [(pair.source, pair.target) for pair in context.scene.parts.pairs
                      if pair.state == state and pair.source in names[0] and pair.target in names[1]]
              for state in ("PINNED", "FORBIDDEN")}
    key = (str(wanted), *(array.tobytes() for shape in shapes for _, *arrays in shape for array in arrays))
    if key not in last_match:
        sc, manager = core(), context.window_manager
        manager.progress_begin(0, 1)
        try:
            found = sc.match(*(sc.Shape(shape, side) for shape, side in zip(shapes, ("source", "target"))),
                             pinned=wanted["PINNED"], forbidden=wanted["FORBIDDEN"],
                             progress=lambda share, step: manager.progress_update(share))
        finally:
            manager.progress_end()
        last_match.clear()
        last_match[key] = found
    return last_match[key]


def colours_of(match):
    """By side, the colour of every part: that of its role, as on pages."""
    def linear(value):
        return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4
    return {side: {name: (*(linear(int(text[k:k + 2], 16) / 255) for k in (1, 3, 5)), 1) for name, text in colours.items()}
            for side, colours in match.colours.items()}


def material(colour):
    name = "Part " + "".join(f"{round(255 * value):02x}" for value in colour[:3])
    result = bpy.data.materials.get(name)
    if result is None:
        result = bpy.data.materials.new(name)
        result.diffuse_color = colour
        result.use_nodes = True
        result.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = colour
    return result


def show_pairs(match, context):
    """Lists the pairs, of which pinned and forbidden ones stay, and colours the parts."""
    pairs = context.scene.parts.pairs
    kept = [(pair.source, pair.target, pair.state) for pair in pairs if pair.state != "FREE"]
    pairs.clear()
    labels = match.labels
    states = {(source, target): state for source, target, state in kept}
    confidences = dict(zip(match.pairs, match.confidences or []))
    for source, target in [*match.pairs, *(pair for pair in states if pair not in match.pairs)]:
        pair = pairs.add()
        pair.source, pair.target = source, target
        pair.text = f"{labels['source'].get(source, source)} \N{RIGHTWARDS ARROW} {labels['target'].get(target, target)}"
        pair.state = states.get((source, target), "FREE")
        pair.confidence = confidences.get((source, target), 0)
    colours = colours_of(match)
    for side in ("source", "target"):
        for thing in chosen(side, context):
            thing.color = colours[side].get(thing.name, GREY)
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.spaces.active.shading.color_type = "OBJECT"


def select_pair(settings, context):
    """Selects both objects of the pair that is clicked."""
    if 0 <= settings.index < len(settings.pairs):
        pair = settings.pairs[settings.index]
        for thing in context.view_layer.objects:
            thing.select_set(thing.name in (pair.source, pair.target))


class Operator(bpy.types.Operator):
    """Base of operators that shows errors as messages."""

    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        try:
            self.report({"INFO"}, self.run(context))
        except (RuntimeError, ValueError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class PARTS_OT_match(Operator):
    """Find which parts of the two shapes correspond; pinned and forbidden pairs are kept"""

    bl_idname = "parts.match"
    bl_label = "Match Parts"

    def run(self, context):
        match = matched(context)
        show_pairs(match, context)
        return f"{len(match.pairs)} pairs in {len(match.blocks)} blocks"


class PARTS_OT_state(Operator):
    """Pin or forbid a pair: the next match has it, or does not; click again to take it back"""

    bl_idname = "parts.state"
    bl_label = "Pin or Forbid"
    index: bpy.props.IntProperty()
    state: bpy.props.StringProperty()

    def run(self, context):
        pair = context.scene.parts.pairs[self.index]
        pair.state = "FREE" if pair.state == self.state else self.state
        return f"{pair.source} and {pair.target}: {pair.state.lower()}"


class PARTS_OT_pin_selected(Operator):
    """Pin the two selected objects, one of each shape"""

    bl_idname = "parts.pin_selected"
    bl_label = "Pin Selected"

    def run(self, context):
        ends = [[thing for thing in chosen(side, context) if thing.select_get()] for side in ("source", "target")]
        if [len(end) for end in ends] != [1, 1]:
            raise RuntimeError("Select one object of the source and one of the target")
        names = ends[0][0].name, ends[1][0].name
        pairs = context.scene.parts.pairs
        pair = next((pair for pair in pairs if (pair.source, pair.target) == names), None) or pairs.add()
        pair.source, pair.target = names
        pair.state = "PINNED"
        return f"{names[0]} and {names[1]}: pinned"


class PARTS_OT_blend(Operator):
    """Make objects that become the target during the frames"""

    bl_idname = "parts.blend"
    bl_label = "Blend"

    def run(self, context):
        settings = context.scene.parts
        first, last = settings.frame_start, settings.frame_end
        if last <= first:
            raise RuntimeError("The last frame must be after the first")
        match = matched(context)
        blend = core().blend(None, None, match)
        colours = colours_of(match)
        runs = []
        for frame in range(first, last + 1):
            parts = blend((frame - first) / (last - first)).parts
            offsets = np.cumsum([0, *(len(part.vertices) for part in parts)])
            points = np.concatenate([part.vertices for part in parts])
            faces = np.concatenate([part.faces + offset for part, offset in zip(parts, offsets)])
            if runs and np.array_equal(faces, runs[-1]["faces"]):
                runs[-1]["frames"].append((frame, points))
            else:
                runs.append({"parts": parts, "faces": faces, "frames": [(frame, points)]})
        collection = new_collection("Blend", context)
        for i, run in enumerate(runs):
            thing = new_object(f"Blend {run['frames'][0][0]}", run["frames"][0][1], run["faces"], collection)
            add_materials(thing, run["parts"], colours)
            animate(thing, run["frames"], runs[i + 1]["frames"][0][0] if i + 1 < len(runs) else None, i == 0)
        context.scene.frame_set(first)
        return f"{len(runs)} objects for {last - first + 1} frames"


def add_materials(thing, parts, colours):
    """Gives every face the colour of its part's block."""
    slots = {}
    of_faces = []
    for part in parts:
        source, *_, target = part.name.split("~") * 2  # a part in between is named after both
        colour = colours["source"].get(source) or colours["target"].get(target) or GREY
        if colour not in slots:
            slots[colour] = len(slots)
            thing.data.materials.append(material(colour))
        of_faces += [slots[colour]] * len(part.faces)
    thing.data.polygons.foreach_set("material_index", of_faces)


def set_interpolation(data, path, kind):
    for curve in data.animation_data.action.fcurves:
        if curve.data_path == path:
            for point in curve.keyframe_points:
                point.interpolation = kind


def animate(thing, frames, end, is_first):
    """Absolute shape keys, one for each frame; the object is visible from its first frame until the frame `end`."""
    if len(frames) > 1:
        for frame, points in frames:
            block = thing.shape_key_add(name=f"Frame {frame}", from_mix=False)
            block.interpolation = "KEY_LINEAR"
            block.data.foreach_set("co", to_blender(points).astype(np.float32).ravel())
        keys = thing.data.shape_keys
        keys.use_relative = False
        for (frame, _), block in zip(frames, keys.key_blocks):
            keys.eval_time = block.frame
            keys.keyframe_insert("eval_time", frame=frame)
        set_interpolation(keys, "eval_time", "LINEAR")
    for path in ("hide_viewport", "hide_render"):
        changes = [(frames[0][0], False)]
        if not is_first:
            changes.insert(0, (frames[0][0] - 1, True))
        if end is not None:
            changes.append((end, True))
        for frame, is_hidden in changes:
            setattr(thing, path, is_hidden)
            thing.keyframe_insert(path, frame=frame)
        set_interpolation(thing, path, "CONSTANT")


class PARTS_OT_label(Operator):
    """Give every part a vertex group that is named after its role, such as leg or seat"""

    bl_idname = "parts.label"
    bl_label = "Labels"

    def run(self, context):
        roles = matched(context).roles
        if roles is None:
            raise RuntimeError("The roles of these shapes are not known")
        for side in ("source", "target"):
            for thing in chosen(side, context):
                role = getattr(roles, side).get(thing.name)
                if role:
                    group = thing.vertex_groups.get(role) or thing.vertex_groups.new(name=role)
                    group.add(range(len(thing.data.vertices)), 1, "REPLACE")
        return f"Labels of {len(roles.source)} and {len(roles.target)} parts"


class PARTS_UL_pairs(bpy.types.UIList):
    """Pairs of parts, with buttons to pin and to forbid."""

    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        row = layout.row(align=True)
        row.label(text=item.text)
        row.label(text=f"{item.confidence:.0%}" if item.confidence else "")
        for state, name in (("PINNED", "PINNED" if item.state == "PINNED" else "UNPINNED"), ("FORBIDDEN", "CANCEL")):
            button = row.operator("parts.state", text="", icon=name, depress=item.state == state)
            button.index, button.state = index, state


class PARTS_PT_panel(bpy.types.Panel):
    bl_label = "Shape Correspondence"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Parts"

    def draw(self, context):
        layout, settings = self.layout, context.scene.parts
        for side in ("source", "target"):
            column = layout.column(align=True, heading=side.capitalize())
            column.label(text=side.capitalize())
            column.prop(settings, f"{side}_collection", text="")
            if getattr(settings, f"{side}_collection") is None:
                column.prop(settings, f"{side}_object", text="")
        layout.operator("parts.match", icon="LINKED")
        layout.template_list("PARTS_UL_pairs", "", settings, "pairs", settings, "index")
        layout.operator("parts.pin_selected", icon="PINNED")
        row = layout.row(align=True)
        row.prop(settings, "frame_start")
        row.prop(settings, "frame_end")
        layout.operator("parts.blend", icon="SHAPEKEY_DATA")
        layout.operator("parts.label", icon="GROUP_VERTEX")


class PARTS_pair(bpy.types.PropertyGroup):
    source: bpy.props.StringProperty()
    target: bpy.props.StringProperty()
    text: bpy.props.StringProperty()
    confidence: bpy.props.FloatProperty()
    state: bpy.props.EnumProperty(items=[(state, state.capitalize(), "") for state in ("FREE", "PINNED", "FORBIDDEN")])


class PARTS_settings(bpy.types.PropertyGroup):
    source_collection: bpy.props.PointerProperty(name="Source collection", type=bpy.types.Collection)
    target_collection: bpy.props.PointerProperty(name="Target collection", type=bpy.types.Collection)
    source_object: bpy.props.PointerProperty(name="Source object", type=bpy.types.Object)
    target_object: bpy.props.PointerProperty(name="Target object", type=bpy.types.Object)
    pairs: bpy.props.CollectionProperty(type=PARTS_pair)
    index: bpy.props.IntProperty(update=select_pair)
    frame_start: bpy.props.IntProperty(name="First", default=1)
    frame_end: bpy.props.IntProperty(name="Last", default=50)


class PARTS_preferences(bpy.types.AddonPreferences):
    bl_idname = __name__
    module: bpy.props.StringProperty(
        name="Module", subtype="FILE_PATH",
        description="Folder or wheel of the Python module shape_correspondence, if Blender's Python does not have it")

    def draw(self, context):
        self.layout.prop(self, "module")


CLASSES = (PARTS_pair, PARTS_settings, PARTS_preferences, PARTS_OT_match, PARTS_OT_state, PARTS_OT_pin_selected,
           PARTS_OT_blend, PARTS_OT_label, PARTS_UL_pairs, PARTS_PT_panel)


def register():
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.Scene.parts = bpy.props.PointerProperty(type=PARTS_settings)


def unregister():
    del bpy.types.Scene.parts
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)


if __name__ == "__main__":
    register()
