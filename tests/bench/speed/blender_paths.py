"""blender --background --factory-startup --python blender_paths.py -- FILE FRAMES ANSWER

Milliseconds that Blender's motion paths of one bone take over so many frames, into the file ANSWER.
"""

import statistics
import sys
import time

import bpy
import numpy

if not hasattr(numpy, "bool"):  # Debian's Blender 3.4 is older than its numpy
    numpy.bool = bool

file, frames, answer = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=file)
armature = next(thing for thing in bpy.data.objects if thing.type == "ARMATURE")
bpy.context.view_layer.objects.active = armature
bpy.context.scene.frame_start, bpy.context.scene.frame_end = 0, int(frames) - 1
bpy.ops.object.mode_set(mode="POSE")
bpy.ops.pose.select_all(action="DESELECT")
armature.pose.bones[-1].bone.select = True
armature.pose.animation_visualization.motion_path.type = "RANGE"
times = []
for _ in range(15):
    start = time.process_time()
    bpy.ops.pose.paths_calculate(display_type="RANGE", range="SCENE")
    times.append(1e3 * (time.process_time() - start))
with open(answer, "w", encoding="utf-8") as out:
    out.write(f"{statistics.median(times)}\n")
