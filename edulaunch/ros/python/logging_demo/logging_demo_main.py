"""The program logging_demo_main with two nodes: one logs messages, and the other node offers a service that sets log levels."""

from __future__ import annotations

from typing import Any

from rclcpp_like import CppNode, program
from rclpy.executors import SingleThreadedExecutor
from rclpy.logging import LoggingSeverity, set_logger_level

from logging_demo.srv import ConfigLogger

ROUNDS_BEFORE_DEBUG = 10


class LoggerUsage(CppNode):
    """Logs twice a second. After ten rounds, it sets its logger to DEBUG, so that more messages appear."""

    def __init__(self, **options: Any) -> None:
        super().__init__('logger_usage_demo', **options)
        self._count = 0
        self._timer = self.create_wall_timer(0.5, self._on_timer)
        self._debug_timer = self.create_wall_timer(0.5 * ROUNDS_BEFORE_DEBUG, self._show_debug)

    def _on_timer(self) -> None:
        log = self.get_logger()
        log.info('Timer callback called (this will only log once)', once=True)
        log.info(f"Publishing: 'Current count: {self._count}'")
        if self._divides_twelve():
            log.debug('Count divides into 12 (function evaluated to true)')
        if self._count % 2 == 0:
            log.debug('Count is even (expression evaluated to true)')
        self._count += 1
        if self._count > 15:
            log.warning('Reseting count to 0')
            self._count = 0

    def _divides_twelve(self) -> bool:
        log = self.get_logger()
        if self._count == 0:
            log.error('Modulo divisor cannot be 0')
            return False
        log.debug(f'12 modulo {self._count} is {12 % self._count}')
        return 12 % self._count == 0

    def _show_debug(self) -> None:
        self.get_logger().info('Setting severity threshold to DEBUG')
        set_logger_level('logger_usage_demo', LoggingSeverity.DEBUG)
        self._debug_timer.cancel()


class LoggerConfig(CppNode):
    """Serves the service `config_logger`."""

    def __init__(self, **options: Any) -> None:
        super().__init__('logger_config', **options)
        self._service = self.create_service(ConfigLogger, 'config_logger', self._on_request)

    def _on_request(self, request: Any, response: Any) -> Any:
        log = self.get_logger()
        log.info(f"Incoming request: logger '{request.logger_name}', severity '{request.level}'")
        level = LoggingSeverity.__members__.get(request.level)
        if level is None:
            log.error(f"Unknown severity '{request.level}'")
        else:
            set_logger_level(request.logger_name, level)
        response.success = level is not None
        return response


def _work() -> None:
    executor = SingleThreadedExecutor()
    executor.add_node(LoggerUsage())
    executor.add_node(LoggerConfig())
    executor.spin()


main = program(_work)
