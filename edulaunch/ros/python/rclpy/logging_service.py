"""The two services with which other nodes read and change a node's log levels (`enable_logger_service`)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.ros.passed_on import passed_on
from rclpy.logging import LoggingSeverity, get_logger_level, set_logger_level
from rclpy.qos import qos_profile_services_default

if TYPE_CHECKING:
    from rclpy.impl.protocols import NodeProtocol


class LoggingService:
    """Creates the services `<node>/get_logger_levels` and `<node>/set_logger_levels`."""

    def __init__(self, node: NodeProtocol) -> None:
        from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels

        name = node.get_name()
        node.create_service(
            GetLoggerLevels, f'{name}/get_logger_levels', self._get_logger_levels, qos_profile=qos_profile_services_default
        )
        node.create_service(
            SetLoggerLevels, f'{name}/set_logger_levels', self._set_logger_levels, qos_profile=qos_profile_services_default
        )

    def _get_logger_levels(self, request: Any, response: Any) -> Any:
        from rcl_interfaces.msg import LoggerLevel

        response.levels = [LoggerLevel(name=name, level=int(get_logger_level(name))) for name in request.names]
        return response

    def _set_logger_levels(self, request: Any, response: Any) -> Any:
        from rcl_interfaces.msg import SetLoggerLevelsResult

        results = []
        for level in request.levels:
            try:
                set_logger_level(level.name, LoggingSeverity(level.level))
                results.append(SetLoggerLevelsResult(successful=True))
            except ValueError:
                results.append(SetLoggerLevelsResult(successful=False, reason='Failed reason: Invalid logger level.'))
        response.results = results
        return response


__getattr__ = passed_on(__name__)
