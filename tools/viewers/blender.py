# SPDX-License-Identifier: MIT
"""One frame of a clip as Blender shows it, by its Cycles renderer, which needs no display.

usage: blender --background --factory-startup --python-exit-code 1 --python blender.py -- \
           GLB CLIP SECONDS X0 Y0 X1 Y1 WIDTH HEIGHT OUT.png

The rectangle of the plane z = 0 from (X0, Y0) to (X1, Y1), world units of the file, fills the picture; the background
is transparent. Written for Blender 3.4, Debian 12's.
"""
import math
import sys

import bpy

SAMPLES = 64  # per pixel


def load(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    # Flat: the file has no normals, and 3.4's guess at smoothness fails with numpy 1.24 (np.bool).
    bpy.ops.import_scene.gltf(filepath=path, import_shading="FLAT")


def pose(clip, seconds):
    """The importer makes a muted track for each clip, its keys at seconds · fps."""
    armature = next(o for o in bpy.data.objects if o.type == "ARMATURE")
    track = armature.animation_data.nla_tracks.get(clip)
    if track is None:
        sys.exit(f"blender: no clip {clip}")
    armature.animation_data.use_nla = False
    armature.animation_data.action = track.strips[0].action
    scene = bpy.context.scene
    frame = seconds * scene.render.fps / scene.render.fps_base
    scene.frame_set(math.floor(frame), subframe=frame - math.floor(frame))


def cut_alpha():
    """alphaMode MASK: Blender keeps it as a setting of Eevee's alone, so for Cycles alpha is compared by a node."""
    for material in bpy.data.materials:
        if material.blend_method != "CLIP":
            continue
        tree = material.node_tree
        link = next(l for l in tree.links if l.from_socket.name == "Alpha")
        cut = tree.nodes.new("ShaderNodeMath")
        cut.operation = "GREATER_THAN"
        cut.inputs[1].default_value = material.alpha_threshold
        alpha, factor = link.from_socket, link.to_socket
        tree.links.new(alpha, cut.inputs[0])
        tree.links.new(cut.outputs[0], factor)


def place_camera(x0, y0, x1, y1):
    """glTF's (x, y, z) is (x, −z, y) here: the camera in front of the drawing looks along +y."""
    data = bpy.data.cameras.new("camera")
    data.type = "ORTHO"
    data.ortho_scale = max(x1 - x0, y1 - y0)
    camera = bpy.data.objects.new("camera", data)
    camera.location = ((x0 + x1) / 2, -10, (y0 + y1) / 2)
    camera.rotation_euler = (math.pi / 2, 0, 0)
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def render(width, height, path):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = SAMPLES
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = False
    scene.cycles.pixel_filter_type = "BOX"
    scene.view_settings.view_transform = "Standard"  # colours as they are in the file
    scene.render.film_transparent = True
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)


def main():
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if len(arguments) != 10:
        sys.exit(__doc__)
    glb, clip, *numbers, width, height, out = arguments
    seconds, x0, y0, x1, y1 = map(float, numbers)
    load(glb)
    pose(clip, seconds)
    cut_alpha()
    place_camera(x0, y0, x1, y1)
    render(int(width), int(height), out)


main()
