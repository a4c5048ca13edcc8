"""The program dynamic_frame_tf2_broadcaster: a carrot that jumps from side to side of turtle1."""

from __future__ import annotations

from math import cos, pi, sin

from edulaunch.ros.running import spin
from turtle_tf2_py.fixed_frame_tf2_broadcaster import CarrotPublisher


class DynamicFramePublisher(CarrotPublisher):
    """Ten metres away, at an angle of pi times *whole* seconds, as upstream has it: it flips each second."""

    def place(self, seconds: int) -> tuple[float, float]:
        """On the y axis of the turtle's frame, but for rounding."""
        return 10.0 * sin(seconds * pi), 10.0 * cos(seconds * pi)


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(lambda: DynamicFramePublisher('dynamic_frame_tf2_broadcaster'))


if __name__ == '__main__':
    main()
