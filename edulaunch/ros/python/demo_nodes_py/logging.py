"""The program use_logger_service, in which one node sets the log level of another node with a service."""

from __future__ import annotations

import rclpy
from rcl_interfaces.msg import LoggerLevel
from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String

from edulaunch.ros.running import run

STEPS = (
    ('default', None),
    ('debug', LoggerLevel.LOG_LEVEL_DEBUG),
    ('warn', LoggerLevel.LOG_LEVEL_WARN),
    ('error', LoggerLevel.LOG_LEVEL_ERROR),
)


class LoggerServiceNode(Node):
    """Logs each message at every level."""

    def __init__(self) -> None:
        super().__init__('LoggerServiceNode', enable_logger_service=True)
        self.create_subscription(String, 'output', self._on_message, 10)

    def _on_message(self, message: String) -> None:
        log = self.get_logger()
        log.debug(f'{message.data} with DEBUG logger level.')
        log.info(f'{message.data} with INFO logger level.')
        log.warning(f'{message.data} with WARN logger level.')
        log.error(f'{message.data} with ERROR logger level.')
        log.fatal(f'{message.data} with FATAL logger level.')


def work() -> None:
    """Set the level of a logger several times, log with each level, and request the last level."""
    node, other = Node('TestNode'), LoggerServiceNode()
    log, name = node.get_logger(), other.get_name()
    executor = SingleThreadedExecutor()
    for one in (node, other):
        executor.add_node(one)
    publisher = node.create_publisher(String, 'output', 10)
    set_levels = node.create_client(SetLoggerLevels, f'{name}/set_logger_levels')
    get_levels = node.create_client(GetLoggerLevels, f'{name}/get_logger_levels')
    for number, (label, level) in enumerate(STEPS, 1):
        log.info(f'Output with {label} logger level:')
        if level is not None:
            request = SetLoggerLevels.Request(levels=[LoggerLevel(name=name, level=level)])
            executor.spin_until_future_complete(set_levels.call_async(request))
        publisher.publish(String(data=f'Output {number}'))
        executor.spin_once(timeout_sec=0.5)
    future = get_levels.call_async(GetLoggerLevels.Request(names=[name]))
    executor.spin_until_future_complete(future)
    log.info(f'Current logger level: {future.result().levels[0].level}')
    rclpy.shutdown()


def use_logger_service() -> None:
    """Run the program."""
    run(work)
