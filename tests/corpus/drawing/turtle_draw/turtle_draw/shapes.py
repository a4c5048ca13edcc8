import math
from geometry_msgs.msg import Point


def polygon(n, size, cx=5.5, cy=5.5, skip=1):
    pts = []
    for i in range(n + 1):
        a = math.pi / 2 + 2 * math.pi * (i * skip) / n
        pts.append(Point(x=cx + size * math.cos(a), y=cy + size * math.sin(a)))
    return pts
