#!/usr/bin/env python3
"""A z-buffer in Python that draws ZScope's picture to the bit: renderer.py SCENE.obj CAMERA.json FOLDER [--cull]

Needs nothing but Python 3. The steps and their arithmetic are those of the homework kit in C++.
"""
import ctypes
import json
import struct
import sys


def float32(value):
    return ctypes.c_float(value).value


# ---- scene

def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def flat(points):
    """The face on the two axes on which it is largest, turning left."""
    normal = [0.0, 0.0, 0.0]
    for a, b in zip(points, points[1:] + points[:1]):
        normal[0] += (a[1] - b[1]) * (a[2] + b[2])
        normal[1] += (a[2] - b[2]) * (a[0] + b[0])
        normal[2] += (a[0] - b[0]) * (a[1] + b[1])
    axis = max(range(3), key=lambda i: abs(normal[i]))
    u, v = [(1, 2), (2, 0), (0, 1)][axis]
    if normal[axis] <= 0:
        u, v = v, u
    return [(p[u], p[v]) for p in points]


def fan(face):
    return [(face[0], face[i - 1], face[i]) for i in range(2, len(face))]


def is_convex(points):
    n = len(points)
    return all(turn(points[i], points[(i + 1) % n], points[(i + 2) % n]) >= 0 for i in range(n))


def is_ear(points, at):
    n = len(points)
    a, b, c = points[at - 1], points[at], points[(at + 1) % n]
    others = [p for i, p in enumerate(points) if i not in ((at - 1) % n, at, (at + 1) % n)]
    return turn(a, b, c) > 0 and not any(
        turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0 for p in others)


def split(face, vertices):
    points = flat([vertices[corner] for corner in face])
    if is_convex(points):
        return fan(face)
    triangles = []
    while len(face) > 3:
        ear = next((i for i in range(len(face)) if is_ear(points, i)), None)
        if ear is None:
            break
        triangles.append((face[ear - 1], face[ear], face[(ear + 1) % len(face)]))
        face = face[:ear] + face[ear + 1:]
        points = points[:ear] + points[ear + 1:]
    return triangles + fan(face)


def read_obj(file):
    vertices, triangles = [], []
    with open(file, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            words = line.split("#")[0].split()
            if not words:
                continue
            if words[0] == "v":
                vertices.append(tuple(float(word) for word in words[1:4]))
            elif words[0] == "f":
                numbers = [int(word.split("/")[0]) for word in words[1:]]
                face = [n - 1 if n > 0 else len(vertices) + n for n in numbers]
                triangles += split(face, vertices)
    return vertices, triangles


# ---- camera

class Camera:
    def __init__(self, file):
        with open(file, encoding="utf-8") as stream:
            values = json.load(stream)

        def number(value):  # a number, or a string with a decimal, a hex float or inf
            if not isinstance(value, str):
                return float(value)
            return float.fromhex(value) if "x" in value else float(value)

        for axis in ("eye", "right", "up", "forward"):
            setattr(self, axis, [number(value) for value in values[axis]])
        self.focal, self.near, self.far = (number(values[key]) for key in ("focal", "near", "far"))
        self.width, self.height = int(values["width"]), int(values["height"])


# ---- geometry

def to_view(p, camera):
    d = [p[i] - camera.eye[i] for i in range(3)]
    return tuple((a[0] * d[0] + a[1] * d[1]) + a[2] * d[2] for a in (camera.right, camera.up, camera.forward))


def crossing(a, b, near):
    t = (a[2] - near) / (a[2] - b[2])
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), near)


def clip_near(corners, near):
    kept = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        if a[2] >= near:
            kept.append(a)
        if (a[2] >= near) != (b[2] >= near):
            kept.append(crossing(a, b, near) if a[2] >= near else crossing(b, a, near))
    return kept


def project(v, camera):
    depth = camera.near / v[2]
    scale = ((camera.height * 0.5) * camera.focal) / camera.near
    return (camera.width * 0.5 + (v[0] * depth) * scale, camera.height * 0.5 - (v[1] * depth) * scale, depth)


class ScreenTriangle:
    """Corners in 1/256 pixel, clockwise; depth = a x + b y + c."""

    def __init__(self, number, p):
        self.id = number
        self.x = [round(q[0] * 256) for q in p]
        self.y = [round(q[1] * 256) for q in p]
        self.area = ((self.x[1] - self.x[0]) * (self.y[2] - self.y[0])
                     - (self.y[1] - self.y[0]) * (self.x[2] - self.x[0]))
        if self.area == 0:
            return
        self.set_plane(p)
        if self.area < 0:
            self.x[1], self.x[2] = self.x[2], self.x[1]
            self.y[1], self.y[2] = self.y[2], self.y[1]

    def set_plane(self, p):
        d1, d2 = p[1][2] - p[0][2], p[2][2] - p[0][2]
        corners = [q[:2] for q in p]
        for _ in range(2):
            (x0, y0), (x1, y1), (x2, y2) = corners
            e1x, e1y, e2x, e2y = x1 - x0, y1 - y0, x2 - x0, y2 - y0
            det = e1x * e2y - e2x * e1y
            if abs(det) > max(abs(e1x), abs(e1y), abs(e2x), abs(e2y)) / 1024:
                break
            corners = [(self.x[i] / 256, self.y[i] / 256) for i in range(3)]  # hardly wider than a line
        inverse = 1 / det
        self.a = (d1 * e2y - d2 * e1y) * inverse
        self.b = (d2 * e1x - d1 * e2x) * inverse
        self.c = p[0][2] - (self.a * x0 + self.b * y0)
        self.lo = float32(min(q[2] for q in p))
        self.hi = float32(max(q[2] for q in p))

    def depth_at(self, i, j):
        return min(max(float32(self.a * (i + 0.5) + (self.b * (j + 0.5) + self.c)), self.lo), self.hi)


def to_screen(vertices, triangles, camera, cull):
    for number, triangle in enumerate(triangles):
        kept = clip_near([to_view(vertices[corner], camera) for corner in triangle], camera.near)
        for part in fan(kept):
            t = ScreenTriangle(number, [project(v, camera) for v in part])
            if t.area == 0 or (cull and t.area > 0):
                continue
            yield t


# ---- z-buffer

def draw(triangles, camera):
    width, height = camera.width, camera.height
    depth, ids = [0.0] * (width * height), [-1] * (width * height)
    far = float32(camera.near / camera.far)
    for t in triangles:
        edges = []
        for a, b in ((0, 1), (1, 2), (2, 0)):
            dx, dy = t.x[b] - t.x[a], t.y[b] - t.y[a]
            left_or_top = dy < 0 or (dy == 0 and dx > 0)
            edges.append((dx, dy, t.x[a], t.y[a], 0 if left_or_top else 1))
        x0, x1 = max(-((128 - min(t.x)) // 256), 0), min((max(t.x) - 128) // 256, width - 1)
        y0, y1 = max(-((128 - min(t.y)) // 256), 0), min((max(t.y) - 128) // 256, height - 1)
        for j in range(y0, y1 + 1):
            for i in range(x0, x1 + 1):
                px, py = 256 * i + 128, 256 * j + 128
                if any(dx * (py - ya) - dy * (px - xa) < least for dx, dy, xa, ya, least in edges):
                    continue
                z = t.depth_at(i, j)
                at = j * width + i
                if z < far or z < depth[at] or (z == depth[at] and -1 < ids[at] <= t.id):
                    continue
                depth[at], ids[at] = z, t.id
    return depth, ids


def write_dump(file, width, height, depth, ids):
    """The format of zscope_dump.h: depth and ids, top line first, ids counted from 0."""
    with open(file, "wb") as out:
        out.write(b"ZSDUMP1\n")
        out.write(struct.pack("=9I", 0x01020304, width, height, 1 + 2, 1, 0, 0, 1, 0))
        out.write(struct.pack("=%df" % len(depth), *depth))
        out.write(struct.pack("=%di" % len(ids), *ids))


def main(words):
    if len(words) not in (3, 4) or (len(words) == 4 and words[3] != "--cull"):
        sys.exit("usage: renderer.py SCENE.obj CAMERA.json FOLDER [--cull]")
    vertices, triangles = read_obj(words[0])
    camera = Camera(words[1])
    depth, ids = draw(to_screen(vertices, triangles, camera, len(words) == 4), camera)
    write_dump(words[2] + "/out.zdump", camera.width, camera.height, depth, ids)


if __name__ == "__main__":
    main(sys.argv[1:])
