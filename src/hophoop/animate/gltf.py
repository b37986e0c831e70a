"""A scene as binary glTF 2.0: meshes, colours and the motion as an animation, for any viewer of 3D models.

In glTF Y is up and Z points to the viewer; the scene's X, lane, Z become X, Z, −lane.
"""

from __future__ import annotations

import json
import struct
from itertools import pairwise
from typing import Any

import numpy as np

from hophoop.animate.shapes3d import HEAVY, LOAD, TUBE, torus, torus_faces
from hophoop.results.poses import Floats, to_world

FLOAT, UNSIGNED = 5126, 5125
ARRAY, ELEMENTS = 34962, 34963
TRIANGLES, LINE_STRIP = 4, 3


class _Writer:
    """Collect the parts of a file, each array in its own view of one buffer."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []
        self.meshes: list[dict[str, Any]] = []
        self.materials: list[dict[str, Any]] = []
        self.nodes: list[dict[str, Any]] = []
        self.samplers: list[dict[str, Any]] = []
        self.channels: list[dict[str, Any]] = []

    def array(self, values: Any, target: int | None = None) -> int:
        """Add an accessor for an array of floats or indices."""
        whole = np.asarray(values)
        indices = whole.dtype.kind in "iu"
        whole = whole.astype("<u4" if indices else "<f4")
        while len(self.data) % 4:
            self.data.append(0)
        view: dict[str, Any] = {"buffer": 0, "byteOffset": len(self.data), "byteLength": whole.nbytes}
        if target is not None:
            view["target"] = target
        self.data += whole.tobytes()
        self.views.append(view)
        shape = {1: "SCALAR"} if whole.ndim == 1 else {2: "VEC2", 3: "VEC3", 4: "VEC4"}
        accessor: dict[str, Any] = {
            "bufferView": len(self.views) - 1,
            "componentType": UNSIGNED if indices else FLOAT,
            "count": len(whole),
            "type": shape[1 if whole.ndim == 1 else whole.shape[1]],
        }
        if not indices:
            flat = whole.reshape(len(whole), -1)
            accessor["min"], accessor["max"] = flat.min(axis=0).tolist(), flat.max(axis=0).tolist()
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def material(self, color: str, rough: float = 0.6) -> int:
        parts = [int(color[i : i + 2], 16) / 255.0 for i in (1, 3, 5)]
        # colour factors are linear in glTF
        linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
        self.materials.append(
            {
                "pbrMetallicRoughness": {
                    "baseColorFactor": [*linear, 1.0],
                    "metallicFactor": 0.0,
                    "roughnessFactor": rough,
                },
                "doubleSided": True,
            }
        )
        return len(self.materials) - 1

    def mesh(self, points: Floats, normals: Floats | None, faces: Any, color: str, mode: int = TRIANGLES) -> int:
        attributes = {"POSITION": self.array(points, ARRAY)}
        if normals is not None:
            attributes["NORMAL"] = self.array(normals, ARRAY)
        primitive: dict[str, Any] = {"attributes": attributes, "mode": mode, "material": self.material(color)}
        if faces is not None:
            primitive["indices"] = self.array(np.asarray(faces, dtype=np.uint32).ravel(), ELEMENTS)
        self.meshes.append({"primitives": [primitive]})
        return len(self.meshes) - 1

    def node(self, name: str, **fields: Any) -> int:
        self.nodes.append({"name": name, **fields})
        return len(self.nodes) - 1

    def animate(self, node: int, path: str, times: int, values: Floats) -> None:
        # programs without animation show the start
        self.nodes[node][path] = np.asarray(values[0], dtype=float).tolist()
        self.samplers.append({"input": times, "output": self.array(values), "interpolation": "LINEAR"})
        self.channels.append({"sampler": len(self.samplers) - 1, "target": {"node": node, "path": path}})

    def pack(self, roots: list[int]) -> bytes:
        while len(self.data) % 4:
            self.data.append(0)
        text = {
            "asset": {"version": "2.0", "generator": "hophoop"},
            "scene": 0,
            "scenes": [{"nodes": roots}],
            "nodes": self.nodes,
            "meshes": self.meshes,
            "materials": self.materials,
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.data)}],
            "animations": [{"name": "motion", "samplers": self.samplers, "channels": self.channels}],
        }
        words = json.dumps(text, ensure_ascii=False, separators=(",", ":")).encode("utf-8")
        words += b" " * (-len(words) % 4)
        total = 12 + 8 + len(words) + 8 + len(self.data)
        return b"".join(
            [
                struct.pack("<4sII", b"glTF", 2, total),
                struct.pack("<I4s", len(words), b"JSON"),
                words,
                struct.pack("<I4s", len(self.data), b"BIN\0"),
                bytes(self.data),
            ]
        )


def glb(data: dict[str, Any]) -> bytes:
    """Return a scene as the bytes of a .glb file.

    Parameters
    ----------
    data : dict
        From `hophoop.animate.web.scene_data`.

    Returns
    -------
    content : bytes
    """
    writer = _Writer()
    moments = writer.array(np.arange(data["count"]) / data["fps"])
    slope, size = data["slope"], data["radius"]
    roots = [writer.node("plane", mesh=_plane(writer, data))]
    for i, hoop in enumerate(data["hoops"]):
        radius, lane = hoop["radius"], hoop["lane"]
        points, normals, _ = torus(radius, TUBE * radius)
        quads = torus_faces()
        triangles = np.vstack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
        ring = writer.mesh(_to_gltf(points), _to_gltf(normals), triangles, "#7C8A99")
        load_mesh = writer.mesh(*_ball(LOAD * radius), data["theme"]["load"])
        heavy_mesh = writer.mesh(*_ball(HEAVY * radius), data["colors"]["center"])
        children = [
            writer.node("ring", mesh=ring),
            writer.node("load", mesh=load_mesh, translation=[0.0, hoop["load"], 0.0]),
            writer.node("centre of gravity", mesh=heavy_mesh, translation=[0.0, hoop["heavy"], 0.0]),
        ]
        node = writer.node(f"hoop {i + 1}: {hoop['label']}", children=children)
        roots.append(node)
        writer.animate(node, "translation", moments, _in_lane(hoop["center"], lane))
        half = -0.5 * (hoop["angle"] + slope)  # clockwise
        nothing = np.zeros_like(half)
        writer.animate(node, "rotation", moments, np.stack([nothing, nothing, np.sin(half), np.cos(half)], axis=-1))
        if data["steadyNewton"] > 0.0:
            tilt = [0.0, 0.0, float(np.sin(-0.5 * slope)), float(np.cos(-0.5 * slope))]
            for name, axis in (("normal", 1), ("friction", 0)):
                arrow = writer.mesh(*_arrow(0.03 * size, axis), data["colors"][name])
                pointer = writer.node(f"{name} force {i + 1}", mesh=arrow, rotation=tilt)
                roots.append(pointer)
                writer.animate(pointer, "translation", moments, _in_lane(hoop["contact"], lane - (TUBE + 0.04) * radius))
                scale = np.ones((data["count"], 3))
                length = data["steadyNewton"] * hoop[f"{name}Force"]
                # viewers need an invertible scale for the normals
                scale[:, axis] = np.where(np.abs(length) < 1e-4 * size, 1e-4 * size, length)
                writer.animate(pointer, "scale", moments, scale)
        if hoop["traces"] is not None:
            roots += _trace_nodes(writer, hoop, data, i)
    return writer.pack(roots)


def _trace_nodes(writer: _Writer, hoop: dict[str, Any], data: dict[str, Any], i: int) -> list[int]:
    track, lane = hoop["traces"], hoop["lane"]
    line = writer.mesh(_in_lane(track["load"], lane), None, None, data["theme"]["load"], LINE_STRIP)
    nodes = [writer.node(f"trace of the load {i + 1}", mesh=line)]
    airborne = track["airborne"]
    edges = [0, *(np.flatnonzero(np.diff(airborne[:-1])) + 1).tolist(), len(airborne) - 1]
    for a, b in pairwise(edges):
        if b <= a:
            continue
        color = data["colors"]["airborne" if airborne[a] else "center"]
        part = writer.mesh(_in_lane(track["heavy"][a : b + 1], lane), None, None, color, LINE_STRIP)
        nodes.append(writer.node(f"trace of the centre of gravity {i + 1}", mesh=part))
    return nodes


def _to_gltf(points: Floats) -> Floats:
    return np.stack([points[:, 0], points[:, 2], -points[:, 1]], axis=-1)


def _in_lane(points: Floats, lane: float) -> Floats:
    return np.stack([points[:, 0], points[:, 1], np.full(len(points), -lane)], axis=-1)


def _plane(writer: _Writer, data: dict[str, Any]) -> int:
    radius = data["radius"]
    low, high = data["along"][0] - 4.0 * radius, data["along"][1] + 4.0 * radius
    lanes = max(abs(hoop["lane"]) for hoop in data["hoops"])
    half = lanes + 2.0 * radius
    edge = to_world([low, high, high, low], [0.0] * 4, data["slope"])
    points = np.column_stack([edge, [half, half, -half, -half]])
    up = to_world(0.0, 1.0, data["slope"])
    normals = np.tile([up[0], up[1], 0.0], (4, 1))
    return writer.mesh(points, normals, [[0, 1, 2], [0, 2, 3]], data["theme"]["ground"])


def _ball(radius: float) -> tuple[Floats, Floats, np.ndarray]:
    across, down = 24, 16
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, across + 1), np.linspace(0, np.pi, down + 1), indexing="ij")
    normals = np.stack([np.cos(u) * np.sin(v), np.cos(v), np.sin(u) * np.sin(v)], axis=-1).reshape(-1, 3)
    return radius * normals, normals, _mesh_faces(across, down)


def _arrow(thick: float, axis: int) -> tuple[Floats, Floats, np.ndarray]:
    """Return an arrow of length 1 along X (axis 0) or Y (axis 1)."""
    around = 20
    profile = np.array([[0.0, 0.0], [thick, 0.0], [thick, 0.8], [2.2 * thick, 0.8], [0.0, 1.0]])
    u = np.linspace(0, 2 * np.pi, around + 1)
    # separate faces for each piece of the profile, so that its edges stay sharp
    points: list[Floats] = []
    normals: list[Floats] = []
    faces: list[np.ndarray] = []
    for a, b in pairwise(profile):
        slant = np.array([b[1] - a[1], -(b[0] - a[0])])
        slant = slant / np.hypot(*slant)
        start = sum(len(part) for part in points)
        for radius, level in (a, b):
            points.append(np.stack([radius * np.cos(u), np.full_like(u, level), radius * np.sin(u)], axis=-1))
            normals.append(np.stack([slant[0] * np.cos(u), np.full_like(u, slant[1]), slant[0] * np.sin(u)], axis=-1))
        i = np.arange(around) + start
        j = i + around + 1
        faces += [np.stack([i, j, j + 1], axis=-1), np.stack([i, j + 1, i + 1], axis=-1)]
    order = [0, 1, 2] if axis == 1 else [1, 0, 2]
    return np.vstack(points)[:, order], np.vstack(normals)[:, order], np.vstack(faces)


def _mesh_faces(across: int, down: int) -> np.ndarray:
    i, j = np.meshgrid(np.arange(across), np.arange(down), indexing="ij")
    a = (i * (down + 1) + j).ravel()
    b = a + down + 1
    return np.vstack([np.stack([a, b, b + 1], axis=-1), np.stack([a, b + 1, a + 1], axis=-1)])
