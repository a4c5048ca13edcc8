"""The program joint_state_publisher_gui, without its window of sliders."""

from __future__ import annotations

import rclpy
from joint_state_publisher.joint_state_publisher import JointStatePublisher

from edulaunch.ros.running import run


def work() -> None:
    """Log that there are no sliders, and publish the current positions of the joints."""
    node = JointStatePublisher()
    text = 'edulaunch opens no window with sliders: the joints rest, unless zeros.JOINT or the topics of source_list move them'
    node.get_logger().info(text)
    rclpy.spin(node)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(work, args)


if __name__ == '__main__':
    main()
