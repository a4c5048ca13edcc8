"""The program fixed_frame_tf2_broadcaster: a carrot two metres to the left of turtle1."""

from __future__ import annotations

from turtle_tf2_py._carrot import CarrotPublisher
from turtle_tf2_py._programs import spin


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(lambda: CarrotPublisher('fixed_frame_tf2_broadcaster'))


if __name__ == '__main__':
    main()
