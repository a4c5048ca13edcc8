"""The program dynamic_frame_tf2_broadcaster, which broadcasts a carrot that jumps from side to side of turtle1."""

from __future__ import annotations

from math import cos, pi, sin

from edulaunch.ros.running import spin
from turtle_tf2_py.fixed_frame_tf2_broadcaster import CarrotPublisher


class DynamicFramePublisher(CarrotPublisher):
    """Broadcasts a frame at a distance of ten metres from turtle1.

    As in upstream, the angle of the frame is pi times *whole* seconds, so the frame changes sides each second.
    """

    def place(self, seconds: int) -> tuple[float, float]:
        """Return the position of the carrot, which is on the y axis of the turtle's frame except for rounding."""
        return 10.0 * sin(seconds * pi), 10.0 * cos(seconds * pi)


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(lambda: DynamicFramePublisher('dynamic_frame_tf2_broadcaster'))


if __name__ == '__main__':
    main()
