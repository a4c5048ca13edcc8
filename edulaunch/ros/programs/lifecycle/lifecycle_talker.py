"""The program lifecycle_talker: it publishes while it is active. Its activation takes two seconds."""

from __future__ import annotations

import time

import rclpy
from lifecycle_py.talker import LifecycleTalker
from rclpy.lifecycle import State, TransitionCallbackReturn

from edulaunch.ros.running import run


class SlowTalker(LifecycleTalker):
    """A lifecycle talker whose activation takes some time, so that other nodes must wait for the activation.

    A workspace with a clone of lifecycle_py has its own LifecycleTalker. So this class uses only members that both classes have.
    """

    def on_activate(self, state: State) -> TransitionCallbackReturn:
        """Work for two seconds, and activate the node."""
        result = super().on_activate(state)
        time.sleep(2.0)
        return result


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(lambda: rclpy.spin(SlowTalker('lc_talker')), args)


if __name__ == '__main__':
    main()
