"""The program dynamic_frame_tf2_broadcaster: a carrot that jumps from side to side of turtle1."""

from __future__ import annotations

from math import cos, pi, sin

from edulaunch.ros.running import spin
from turtle_tf2_py.fixed_frame_tf2_broadcaster import CarrotPublisher


class DynamicFramePublisher(CarrotPublisher):
    """Broadcasts a frame at a distance of ten metres. As in upstream, its angle is pi times *whole* seconds, so it changes sides
    each second.
    """

    def place(self, seconds: int) -> tuple[float, float]:
        """Return the position, which is on the y axis of the turtle's frame except for rounding."""
        return 10.0 * sin(seconds * pi), 10.0 * cos(seconds * pi)


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(lambda: DynamicFramePublisher('dynamic_frame_tf2_broadcaster'))


if __name__ == '__main__':
    main()
