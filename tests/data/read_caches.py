# Run by Blender: blender --background --factory-startup --python read_caches.py -- FOLDER
# FOLDER holds cloth.pc2, cloth.mdd and cloth.glb of one run at 25 frames a second. Prints, for each, how far
# Blender's own reader puts any vertex in any frame from where the PC2 has it.
import os
import struct
import sys

import bpy

folder = sys.argv[sys.argv.index("--") + 1]


def path(name):
    return os.path.join(folder, name)


with open(path("cloth.pc2"), "rb") as file:
    data = file.read()
points, _, _, samples = struct.unpack_from("<iffi", data, 16)
frames = [
    [struct.unpack_from("<3f", data, 32 + 12 * (k * points + i)) for i in range(points)] for k in range(samples)
]
scene = bpy.context.scene
scene.render.fps = 25


def worst(thing, place):
    off = 0.0
    for k, frame in enumerate(frames):
        scene.frame_set(k)
        drawn = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
        mesh = drawn.to_mesh()
        assert len(mesh.vertices) == points
        for vertex, wanted in zip(mesh.vertices, frame):
            off = max(off, max(abs(a - b) for a, b in zip(place(thing, vertex.co), wanted)))
        drawn.to_mesh_clear()
    return off


for kind in ("PC2", "MDD"):
    mesh = bpy.data.meshes.new(kind)
    mesh.from_pydata(frames[0], [], [])
    thing = bpy.data.objects.new(kind, mesh)
    scene.collection.objects.link(thing)
    cache = thing.modifiers.new(kind, "MESH_CACHE")
    cache.cache_format = kind
    cache.filepath = path("cloth." + kind.lower())
    cache.frame_start = 0
    print("apart", kind.lower(), worst(thing, lambda _, co: co))


# Blender's z is up: its importer turns the cloth
def turned_back(thing, co):
    x, y, z = thing.matrix_world @ co
    return x, z, -y


try:
    import numpy
except ImportError:
    print("no numpy")
    sys.exit()
if not hasattr(numpy, "bool"):
    numpy.bool = bool  # Debian 12's importer asks for the name that its numpy no longer has
before = set(bpy.data.objects)
bpy.ops.import_scene.gltf(filepath=path("cloth.glb"), merge_vertices=False)
thing = next(o for o in set(bpy.data.objects) - before if o.type == "MESH")
print("apart glb", worst(thing, turned_back))
print("uv", len(thing.data.uv_layers), "two-sided", not thing.data.materials[0].use_backface_culling)
