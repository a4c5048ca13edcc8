"""Lines with fewer points."""

from __future__ import annotations

import math

Point = tuple[float, float]


def thinned(points: list[Point], tolerance_m: float = 0.002) -> list[Point]:
    """The same line with fewer points: no point that is left out is further than the tolerance from the line that remains.

    From the last point kept, each further point allows a cone of directions. A line can go on while its cones have a direction
    in common and it does not turn back.
    """
    kept = [points[0]]
    (x0, y0), low, high, reach, axis = points[0], -math.inf, math.inf, 0.0, 0.0
    for before, (x, y) in zip(points, points[1:], strict=False):
        if before == (x, y):
            continue  # standing still is common, and adds nothing
        distance = math.hypot(x - x0, y - y0)
        if distance > tolerance_m or reach > tolerance_m:
            turn = math.remainder(math.atan2(y - y0, x - x0) - axis, math.tau) if reach else 0.0
            if not (low <= turn <= high and distance >= reach):
                kept.append(before)
                (x0, y0), low, high, reach = before, -math.inf, math.inf, 0.0
                distance = math.hypot(x - x0, y - y0)
                turn = 0.0
            if not reach and distance > tolerance_m:
                axis = math.atan2(y - y0, x - x0)
            if distance > tolerance_m:
                half = math.asin(tolerance_m / distance)
                low, high, reach = max(low, turn - half), min(high, turn + half), distance
    return [*kept, points[-1]]
