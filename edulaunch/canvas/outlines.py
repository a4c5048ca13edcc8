"""The outline of a robot from above, as polygons in metres around its base, facing along +x. The outline comes from a URDF or a
footprint.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable
from typing import NamedTuple
from xml.etree import ElementTree

Point = tuple[float, float]
Vector = tuple[float, float, float]
Matrix = tuple[Vector, Vector, Vector]

FOOTPRINTS = ('footprint', 'robot_radius')
"""The parameters of navigation that describe the footprint of a robot."""
ROUND = 16
"""The number of corners of a circle."""
DEEPEST = 200
"""The maximum number of links in a chain. It prevents an endless loop if a description contains a loop."""


class Part(NamedTuple):
    """One shape of an outline: its kind, which is 'body', 'wheel' (a horizontal cylinder) or 'nose', and its corners."""

    kind: str
    corners: list[Point]


class _Pose(NamedTuple):
    """The pose of a link in the root link: the position in metres, and the rows of the rotation matrix."""

    place: Vector
    turn: Matrix

    def at(self, point: Vector) -> Vector:
        x, y, z = (place + _dot(row, point) for place, row in zip(self.place, self.turn, strict=True))
        return (x, y, z)

    def then(self, inner: _Pose) -> _Pose:
        columns = list(zip(*inner.turn, strict=True))
        a, b, c = (tuple(_dot(row, column) for column in columns) for row in self.turn)
        return _Pose(self.at(inner.place), (a, b, c))  # type: ignore[arg-type]


_HERE = _Pose((0.0, 0.0, 0.0), ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))


def outline_of(description: str) -> list[Part]:
    """Return the shapes of a URDF from above, the lowest first, with every joint at 0. Return [] for an invalid URDF.

    Each link has its collision shapes or, without collision shapes, its visual shapes. Boxes, cylinders and spheres are
    supported, meshes are not. The last part is an arrow in the robot's forward direction.
    """
    if '<!DOCTYPE' in description or '<!ENTITY' in description:
        return []  # no robot needs entities, and they can expand without limit
    try:
        robot = ElementTree.fromstring(description)
        poses = _poses(robot)
        found = [
            shape for link in robot.findall('link') for shape in _shapes(link, poses.get(link.get('name', ''), _HERE)) if shape
        ]
    except (ElementTree.ParseError, ValueError):
        return []
    return _with_nose([Part(kind, corners) for _, kind, corners in sorted(found, key=lambda shape: shape[0])])


def outline_of_footprint(text: str) -> list[Part]:
    """Return the polygon of a footprint parameter of navigation, in metres. Return [] for an invalid value.

    The value is a list of corners '[[0.2, 0.1], [-0.2, 0.1], ...]' or a radius.
    """
    try:
        given = json.loads(text)
        corners = _circle(float(given)) if isinstance(given, (int, float)) else [(float(x), float(y)) for x, y in given]
    except (TypeError, ValueError):
        return []
    return _with_nose([Part('body', _rounded(corners))]) if len(corners) > 2 and all(map(math.isfinite, sum(corners, ()))) else []


def _with_nose(parts: list[Part]) -> list[Part]:
    """Return the parts, with an additional arrow over the front half."""
    if not parts:
        return []
    xs, ys = zip(*(corner for part in parts for corner in part.corners), strict=True)
    front, long, wide = max(xs), max(xs) - min(xs), max(ys) - min(ys)
    size = min(long, wide)
    back, notch, half = front - size * 0.6, front - size * 0.45, size * 0.28
    return [*parts, Part('nose', _rounded([(front, 0.0), (back, half), (notch, 0.0), (back, -half)]))]


def _poses(robot: ElementTree.Element) -> dict[str, _Pose]:
    """Return the pose of each link in the root link."""
    above: dict[str, tuple[str, _Pose]] = {}
    for joint in robot.findall('joint'):
        parent, child = joint.find('parent'), joint.find('child')
        if parent is not None and child is not None:
            above[child.get('link', '')] = (parent.get('link', ''), _origin(joint))
    found = {}
    for link in above:
        name, pose = link, _HERE
        for _ in range(DEEPEST):
            if name not in above:
                break
            name, step = above[name]
            pose = step.then(pose)
        found[link] = pose
    return found


def _origin(element: ElementTree.Element) -> _Pose:
    origin = element.find('origin')
    if origin is None:
        return _HERE
    (x, y, z), (roll, pitch, yaw) = (_three(origin.get(name, '0 0 0')) for name in ('xyz', 'rpy'))
    cr, sr, cp, sp, cy, sy = (function(angle) for angle in (roll, pitch, yaw) for function in (math.cos, math.sin))
    first = (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr)
    second = (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr)
    return _Pose((x, y, z), (first, second, (-sp, cp * sr, cp * cr)))


def _three(text: str) -> Vector:
    """Return the three finite numbers in a string.

    :raises ValueError: when the string is anything else.
    """
    x, y, z = map(float, text.split())
    if not math.isfinite(x + y + z):
        raise ValueError(text)
    return (x, y, z)


def _shapes(link: ElementTree.Element, pose: _Pose) -> Iterable[tuple[float, str, list[Point]] | None]:
    """Yield (height, kind, corners) for each shape of a link."""
    for name in ('collision', 'visual'):
        found = [_shape(element, pose.then(_origin(element))) for element in link.findall(name)]
        if any(found):
            return found
    return []


def _shape(element: ElementTree.Element, pose: _Pose) -> tuple[float, str, list[Point]] | None:
    kind = 'body'
    if (box := element.find('geometry/box')) is not None:
        half = [size / 2 for size in _three(box.get('size', ''))]
        points = [(a * half[0], b * half[1], c * half[2]) for a in (1, -1) for b in (1, -1) for c in (1, -1)]
    elif (cylinder := element.find('geometry/cylinder')) is not None:
        radius, length = float(cylinder.get('radius', '')), float(cylinder.get('length', ''))
        points = [(x, y, side * length / 2) for x, y in _circle(radius) for side in (1, -1)]
        kind = 'wheel' if abs(pose.turn[2][2]) < 0.5 else 'body'
    elif (sphere := element.find('geometry/sphere')) is not None:
        radius = float(sphere.get('radius', ''))
        x, y, z = pose.place
        return z + radius, kind, _rounded((x + a, y + b) for a, b in _circle(radius))
    else:
        return None
    seen = [pose.at(point) for point in points]
    return max(point[2] for point in seen), kind, _rounded(_hull([(x, y) for x, y, _ in seen]))


def _circle(radius: float) -> list[Point]:
    return [(radius * math.cos(math.tau * i / ROUND), radius * math.sin(math.tau * i / ROUND)) for i in range(ROUND)]


def _hull(points: list[Point]) -> list[Point]:
    """Return the corners of the smallest convex polygon around points, counter-clockwise."""
    ordered = sorted(set(points))

    def chain(some: Iterable[Point]) -> list[Point]:
        found: list[Point] = []
        for x, y in some:
            while len(found) > 1:
                (ax, ay), (bx, by) = found[-2:]
                if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 1e-12:
                    break
                found.pop()
            found.append((x, y))
        return found[:-1]

    return chain(ordered) + chain(reversed(ordered))


def _rounded(points: Iterable[Point]) -> list[Point]:
    """Round to a tenth of a millimetre, like all other lengths on the page."""
    return [(round(x, 4) + 0.0, round(y, 4) + 0.0) for x, y in points]


def _dot(a: Iterable[float], b: Iterable[float]) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))
