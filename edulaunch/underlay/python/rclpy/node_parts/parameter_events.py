"""Telling others about a node's parameters: /parameter_events, and the record."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from edulaunch.facts import with_facts
from edulaunch.graph.ros_arguments import Override
from rclpy._rclpy_pybind11 import RCLError
from rclpy.constants import S_TO_NS
from rclpy.node_parts.core import core_of
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_parameter_events

if TYPE_CHECKING:
    from rclpy.node import Node


class ParameterEvents:
    """Publishes one rcl_interfaces/ParameterEvent for each successful declaration or change of a node."""

    def __init__(self, node: Node) -> None:
        from rcl_interfaces.msg import Parameter as ParameterMsg
        from rcl_interfaces.msg import ParameterEvent

        self._core = core_of(node)
        self._to_wire = ParameterMsg.to_wire
        self._publisher = node.create_publisher(ParameterEvent, '/parameter_events', qos_profile_parameter_events)
        self._declared: set[str] = set()

    @staticmethod
    def from_arguments(parameters: Iterable[Parameter]) -> dict[str, Override]:
        """The constructor's `parameter_overrides`, in the form of those of the command line."""
        return {parameter.name: Override(parameter.value, 'parameter_overrides') for parameter in parameters}

    def publish(self, new: list[Parameter], changed: list[Parameter], deleted: list[Parameter]) -> None:
        """Tell of one transaction.

        :raises RCLError: after shutdown; the values are in place then, as in ROS 2.
        """
        core = self._core
        for parameter in (*new, *changed):
            core.graph.tracer.parameter(core.entry, parameter.name, parameter.value, self._origin(parameter))
        for parameter in new:
            self._describe(parameter.name)
        for parameter in deleted:
            core.graph.tracer.parameter(core.entry, parameter.name, None, 'set_parameters')
        if not core.context.alive:
            raise with_facts(RCLError("Failed to publish: publisher's context is invalid"), 'programs.after-shutdown')
        stamp = divmod(core.clock.now_ns(), S_TO_NS)
        self._publisher._send((*stamp, core.full_name, self._wires(new), self._wires(changed), self._wires(deleted)))

    def _describe(self, name: str) -> None:
        """Tell what a parameter is declared to be, where that says more than its type."""
        core = self._core
        said = core.parameters.descriptors[name]
        limits = [(each.from_value, each.to_value, each.step) for each in (*said.integer_range, *said.floating_point_range)]
        if said.description or said.read_only or limits:
            core.graph.tracer.descriptor(core.entry, name, said.description, said.read_only, limits[0] if limits else None)

    def _wires(self, parameters: list[Parameter]) -> tuple[Any, ...]:
        return tuple([self._to_wire(parameter.to_parameter_msg()) for parameter in parameters])

    def _origin(self, parameter: Parameter) -> str:
        """Where a value came from, in words: at its declaration from outside or the program, later from a change."""
        if parameter.name in self._declared:
            return 'set_parameters'
        self._declared.add(parameter.name)
        override = self._core.overrides.get(parameter.name)
        return 'default' if override is None or override.value != parameter.value else override.origin
