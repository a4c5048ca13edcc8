"""The programs one_off_timer and reuse_timer. Every third call of a periodic timer starts a timer that fires only once."""

from __future__ import annotations

from functools import partial
from typing import Any

from rclcpp_like import CppNode, spinning


class TwoTimers(CppNode):
    """The node of both programs.

    :param reuse: whether to reset the cancelled timer (True), or to create a new timer in its place (False).
    """

    def __init__(self, node_name: str, *, reuse: bool, **options: Any) -> None:
        super().__init__(node_name, **options)
        self._reuse = reuse
        self._number = 0
        self._periodic = self.create_wall_timer(2.0, self._on_periodic)
        self._one_off: Any = self.create_wall_timer(1.0, self._on_one_off)
        if reuse:
            self._one_off.cancel()

    def _on_one_off(self) -> None:
        self.get_logger().info('in one_off_timer callback')
        self._one_off.cancel()

    def _on_periodic(self) -> None:
        log = self.get_logger()
        log.info('in periodic_timer callback')
        self._number += 1
        if self._number % 3 != 1:
            log.info('  not resetting one off timer')
            return
        log.info('  resetting one off timer')
        if self._reuse:
            self._one_off.reset()
        else:
            self.destroy_timer(self._one_off)
            self._one_off = self.create_wall_timer(1.0, self._on_one_off)


OneOffTimer = partial(TwoTimers, 'one_off_timer', reuse=False)
ReuseTimer = partial(TwoTimers, 'reuse_timer', reuse=True)
one_off_timer = spinning(OneOffTimer)
reuse_timer = spinning(ReuseTimer)
