"""Where Blender puts the vertices of a file, for check_readers.py: run inside Blender, which has a Python of its own.

    blender --background --factory-startup --python-exit-code 1 --python blender_positions.py -- FILE.glb TIME... > OUT

Prints one line that begins with "POSITIONS " and holds JSON: for each time a list for each mesh of the file by its index: the corners
of its triangles in the scene, glTF's axes, in the order of the file. The file has one clip.
"""

import json
import sys

import bpy
import numpy

numpy.bool = bool  # a name that newer versions dropped and the importer of Blender 3.4 asks for


def positions(thing, graph):
    """Corners of the triangles, in world space, glTF's axes: y is up."""
    seen = thing.evaluated_get(graph)
    mesh = seen.to_mesh()
    places = numpy.empty(3 * len(mesh.vertices))
    mesh.vertices.foreach_get("co", places)
    matrix = numpy.array(seen.matrix_world)
    world = places.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
    corners = numpy.empty(len(mesh.loops), dtype=int)
    mesh.loops.foreach_get("vertex_index", corners)
    seen.to_mesh_clear()
    world = world[corners]
    return numpy.stack([world[:, 0], world[:, 2], -world[:, 1]], axis=1)


def main():
    file, *times = sys.argv[sys.argv.index("--") + 1:]
    bpy.ops.wm.read_homefile(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps = 30
    bpy.ops.import_scene.gltf(filepath=file, import_shading="NORMALS")
    meshes = sorted((thing for thing in scene.objects if thing.type == "MESH" and "check_node" in thing), key=lambda thing: thing["check_node"])
    result = []
    for text in times:
        frame = float(text) * scene.render.fps
        scene.frame_set(int(frame // 1), subframe=frame % 1)
        graph = bpy.context.evaluated_depsgraph_get()
        result.append({str(thing["check_node"]): positions(thing, graph).round(9).ravel().tolist() for thing in meshes})
    print("POSITIONS " + json.dumps(result))


main()
