"""The parameters of one node, the rules for changing them, and the reports of changes to /parameter_events and the recording."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any
from warnings import warn

from edulaunch.engine.facts import with_facts
from edulaunch.engine.graph.parameters import float_range_problem, integer_range_problem
from edulaunch.engine.graph.ros_arguments import Override
from rclpy.constants import S_TO_NS
from rclpy.exceptions import InvalidParameterTypeException, InvalidParameterValueException, ParameterNotDeclaredException
from rclpy.impl.facts import note_no_result
from rclpy.impl.refusals import after_shutdown, student_level
from rclpy.node_parts.core import core_of
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_parameter_events

if TYPE_CHECKING:
    from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult

    from rclpy.impl.protocols import NodeProtocol


OnChange = Callable[[list[Parameter], list[Parameter], list[Parameter]], None]
"""A function that is called after a transaction, with the new, the changed and the deleted parameters."""

EMPTY_LIST = (
    'parameter list cannot be empty, this might be due to pre_set_parameters_callback modifying the original parameters list.'
)


class ParameterStore:
    """The values and descriptors of parameters by name, and the callbacks that may reject a change.

    :param check_alive: called before each transaction; it raises an error if the node was destroyed.
    :param on_change: called after each successful transaction, when the values are set.
    """

    def __init__(self, allow_undeclared: bool, check_alive: Callable[[], None], on_change: OnChange) -> None:
        self.values: dict[str, Parameter] = {}
        self.descriptors: dict[str, ParameterDescriptor] = {}
        self.allow_undeclared = allow_undeclared
        self.pre_callbacks: list[Callable[[list[Parameter]], list[Parameter]]] = []
        self.on_callbacks: list[Callable[[list[Parameter]], SetParametersResult]] = []
        self.post_callbacks: list[Callable[[list[Parameter]], None]] = []
        self._check_alive = check_alive
        self._on_change = on_change

    def descriptor(self, name: str) -> ParameterDescriptor:
        """Return the descriptor of a parameter.

        :raises ParameterNotDeclaredException: when the parameter is not declared, and undeclared parameters are not allowed.
        """
        if name in self.descriptors:
            return self.descriptors[name]
        if not self.allow_undeclared:
            raise undeclared(name, self.values)
        from rcl_interfaces.msg import ParameterDescriptor

        return ParameterDescriptor()

    def declare(self, parameter: Parameter, descriptor: ParameterDescriptor) -> None:
        """Add a parameter, and check its value as in a change. Unlike in a change, the value may be missing, and the parameter
        may be read-only.

        :raises InvalidParameterTypeException, InvalidParameterValueException: when the value is rejected.
        """
        result = self._checked([parameter], {parameter.name: descriptor}, check_read_only=False)
        if result.successful:
            self._store([parameter], {parameter.name: descriptor})
        elif result.reason.startswith('Wrong parameter type'):
            raise InvalidParameterTypeException(parameter, Parameter.Type(descriptor.type).name)
        else:
            raise InvalidParameterValueException(parameter.name, parameter.value, result.reason)

    def set_atomically(self, parameters: list[Parameter]) -> SetParametersResult:
        """Change several parameters, or no parameter if one change is rejected."""
        if self.pre_callbacks:
            parameters = [parameter for callback in self.pre_callbacks for parameter in callback(parameters)]
            if not parameters:
                return _result(EMPTY_LIST)
            self.check_declared(parameters)
        result = self._checked(parameters, self.descriptors, check_read_only=True)
        if result.successful:
            self._store(parameters, None)
        return result

    def check_declared(self, parameters: Iterable[Parameter]) -> None:
        """Check that all parameters are declared, unless undeclared parameters are allowed.

        As in rclpy, the message leaves out the first name, because the test for an empty iterator has consumed it.

        :raises TypeError: when an item is not a Parameter.
        :raises ParameterNotDeclaredException: when there are undeclared parameters that are not allowed.
        """
        names = []
        for parameter in parameters:
            if not isinstance(parameter, Parameter):
                raise TypeError(f"parameter must be instance of type '{Parameter!r}'")
            if parameter.name not in self.values:
                names.append(parameter.name)
        if names and not self.allow_undeclared:
            raise undeclared(names[0], self.values, names[1:])

    def _checked(
        self, parameters: list[Parameter], descriptors: dict[str, ParameterDescriptor], check_read_only: bool
    ) -> SetParametersResult:
        for parameter in parameters:
            descriptor = descriptors.get(parameter.name)
            reason = None if descriptor is None else self.problem(parameter, descriptor, check_read_only)
            if reason is not None:
                return _result(reason)
        for callback in self.on_callbacks:
            result = callback(parameters)
            if getattr(result, 'successful', None) is None:  # usually caused by a forgotten return
                note_no_result(callback)
                warn('Callback returned an invalid type, it should return SetParameterResult.', stacklevel=student_level())
                return _result('Callback returned an invalid type')
            if not result.successful:
                return result
        return _result(None)

    def problem(self, parameter: Parameter, descriptor: ParameterDescriptor, check_read_only: bool) -> str | None:
        """Return the reason why a descriptor does not allow a value, with rclpy's wording, or None if the value is allowed."""
        type_ = parameter.type_
        if check_read_only and descriptor.read_only:
            return f'Trying to set a read-only parameter: {parameter.name}.'
        if descriptor.dynamic_typing:
            descriptor.type = type_.value
        elif type_ is Parameter.Type.NOT_SET:
            if parameter.name in self.values:
                return 'Static parameter cannot be undeclared'
        elif type_.value != descriptor.type:
            return f"Wrong parameter type, expected '{Parameter.Type(descriptor.type)}' got '{type_}'"
        if type_ is Parameter.Type.INTEGER and descriptor.integer_range:
            limits = descriptor.integer_range[0]
            return integer_range_problem(parameter.name, parameter.value, limits.from_value, limits.to_value, limits.step)
        if type_ is Parameter.Type.DOUBLE and descriptor.floating_point_range:
            limits = descriptor.floating_point_range[0]
            return float_range_problem(parameter.name, parameter.value, limits.from_value, limits.to_value, limits.step)
        return None

    def _store(self, parameters: Sequence[Parameter], new_descriptors: dict[str, ParameterDescriptor] | None) -> None:
        self._check_alive()
        new: list[Parameter] = []
        changed: list[Parameter] = []
        deleted: list[Parameter] = []
        for parameter in parameters:
            name = parameter.name
            known = self.values.get(name)
            if new_descriptors is None and parameter.type_ is Parameter.Type.NOT_SET:
                deleted.append(parameter)
                self.values.pop(name, None)
                self.descriptors.pop(name, None)
                continue
            if new_descriptors is not None:
                self.descriptors[name] = new_descriptors[name]
            elif name not in self.descriptors:
                self.descriptors[name] = _dynamic_descriptor()
            (new if known is None or known.type_ is Parameter.Type.NOT_SET else changed).append(parameter)
            self.values[name] = parameter
        self._on_change(new, changed, deleted)
        for callback in self.post_callbacks:
            callback(list(parameters))


def undeclared(name: str, declared: Iterable[str], shown: list[str] | None = None) -> ParameterNotDeclaredException:
    """Return the error for undeclared parameters. `shown` is the list of names in the message (default: `name`)."""
    error = ParameterNotDeclaredException(name if shown is None else shown)
    return with_facts(error, 'programs.parameter-undeclared', parameter=name, declared=list(declared))


def _result(problem: str | None) -> SetParametersResult:
    from rcl_interfaces.msg import SetParametersResult

    result = SetParametersResult()
    result.successful = problem is None
    result.reason = problem or ''
    return result


def _dynamic_descriptor() -> ParameterDescriptor:
    from rcl_interfaces.msg import ParameterDescriptor

    return ParameterDescriptor(dynamic_typing=True)


class ParameterEvents:
    """Publishes one rcl_interfaces/ParameterEvent for each successful declaration or change of a node."""

    def __init__(self, node: NodeProtocol) -> None:
        from rcl_interfaces.msg import Parameter as ParameterMsg
        from rcl_interfaces.msg import ParameterEvent

        self._core = core_of(node)
        self._to_wire = ParameterMsg.to_wire
        self._publisher = node.create_publisher(ParameterEvent, '/parameter_events', qos_profile_parameter_events)
        self._declared: set[str] = set()

    @staticmethod
    def from_arguments(parameters: Iterable[Parameter]) -> dict[str, Override]:
        """Return the constructor's `parameter_overrides` in the form of command-line values."""
        return {parameter.name: Override(parameter.value, 'parameter_overrides') for parameter in parameters}

    def publish(self, new: list[Parameter], changed: list[Parameter], deleted: list[Parameter]) -> None:
        """Publish one event for a transaction.

        :raises RCLError: after shutdown. As in ROS 2, the values have been set by then.
        """
        core = self._core
        for parameter in (*new, *changed):
            core.graph.tracer.parameter(core.entry, parameter.name, parameter.value, self._origin(parameter))
        for parameter in new:
            self._describe(parameter.name)
        for parameter in deleted:
            core.graph.tracer.parameter(core.entry, parameter.name, None, 'set_parameters')
        if not core.context.alive:
            raise after_shutdown('Failed to publish: publisher')
        stamp = divmod(core.clock.rcl_now_ns(), S_TO_NS)
        self._publisher.send_wire((*stamp, core.full_name, self._wires(new), self._wires(changed), self._wires(deleted)))

    def _describe(self, name: str) -> None:
        """Record the declaration of a parameter, if its descriptor contains more than the type."""
        core = self._core
        descriptor = core.parameters.descriptors[name]
        limits = [
            (each.from_value, each.to_value, each.step) for each in (*descriptor.integer_range, *descriptor.floating_point_range)
        ]
        if descriptor.description or descriptor.read_only or limits:
            core.graph.tracer.descriptor(
                core.entry, name, descriptor.description, descriptor.read_only, limits[0] if limits else None
            )

    def _wires(self, parameters: list[Parameter]) -> tuple[Any, ...]:
        return tuple([self._to_wire(parameter.to_parameter_msg()) for parameter in parameters])

    def _origin(self, parameter: Parameter) -> str:
        """Return a description of the origin of a value: the override or the program at the declaration, and a change later."""
        if parameter.name in self._declared:
            return 'set_parameters'
        self._declared.add(parameter.name)
        override = self._core.overrides.get(parameter.name)
        return 'default' if override is None or override.value != parameter.value else override.origin
