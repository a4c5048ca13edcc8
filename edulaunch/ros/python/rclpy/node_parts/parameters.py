"""The methods of a node that handle parameters."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any
from warnings import warn

from rclpy.exceptions import (
    InvalidParameterException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from rclpy.impl.refusals import student_level
from rclpy.node_parts.core import NodeCore
from rclpy.node_parts.parameter_store import undeclared
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter, parameter_value_to_python

if TYPE_CHECKING:
    from rcl_interfaces.msg import ListParametersResult, ParameterDescriptor, ParameterValue, SetParametersResult

    from edulaunch.engine.graph.ros_arguments import Override

OnSet = Callable[[list[Parameter]], 'SetParametersResult']

NAME_ONLY = (
    "when declaring parameter named '{}', declaring a parameter only providing its name is deprecated. You have to either:\n"
    '\t- Pass a name and a default value different to "PARAMETER NOT SET" (and optionally a descriptor).\n'
    '\t- Pass a name and a parameter type.\n'
    '\t- Pass a name and a descriptor with `dynamic_typing=True'
)


class NodeParameters:
    """The part of `Node` that handles parameters."""

    _rclpy: NodeCore
    PARAM_REL_TOL = 1e-6

    def declare_parameter(
        self, name: str, value: Any = None, descriptor: ParameterDescriptor | None = None, ignore_override: bool = False
    ) -> Parameter:
        """Declare a parameter, with a default value or a `Parameter.Type`. An override replaces the default.

        :raises ParameterAlreadyDeclaredException: when the parameter is already declared.
        :raises InvalidParameterTypeException: when the override has another type (5 is not a double, 5.0 is).
        :raises InvalidParameterValueException: when a range or a callback rejects the value.
        """
        entry: tuple[Any, ...] = (name,)
        if value is not None or descriptor is not None:
            from rcl_interfaces.msg import ParameterDescriptor

            entry = (name, value, descriptor or ParameterDescriptor())
        return self.declare_parameters('', [entry], ignore_override)[0]

    def declare_parameters(
        self, namespace: str, parameters: Sequence[tuple[Any, ...]], ignore_override: bool = False
    ) -> list[Parameter]:
        """Declare several parameters.

        :param namespace: a prefix; each parameter is named `namespace.name`.
        :param parameters: tuples (name,), (name, value) or (name, value, descriptor).
        :raises ParameterAlreadyDeclaredException: when a parameter is already declared. Then no parameter is declared.
        """
        core = self._rclpy
        overrides: Mapping[str, Override] = {} if ignore_override else core.overrides
        prepared = [_prepared(overrides, namespace, index, entry) for index, entry in enumerate(parameters)]
        declared = [parameter.name for parameter, _ in prepared if parameter.name in core.parameters.values]
        if declared:
            raise ParameterAlreadyDeclaredException(declared)
        for parameter, descriptor in prepared:
            core.declared.add(parameter.name)
            core.parameters.declare(parameter, descriptor)
        return [core.parameters.values[parameter.name] for parameter, _ in prepared]

    def undeclare_parameter(self, name: str) -> None:
        """Undeclare a parameter.

        :raises ParameterNotDeclaredException: when the parameter is not declared.
        :raises ParameterImmutableException: when the parameter is read-only.
        """
        store = self._rclpy.parameters
        if name not in store.values:
            raise ParameterNotDeclaredException(name)
        if store.descriptors[name].read_only:
            raise ParameterImmutableException(name)
        del store.values[name]
        del store.descriptors[name]
        self._rclpy.graph.tracer.parameter(self._rclpy.entry, name, None, 'undeclare_parameter')

    def has_parameter(self, name: str) -> bool:
        """Return whether a parameter is declared."""
        return name in self._rclpy.parameters.values

    def get_parameter(self, name: str) -> Parameter:
        """Return a parameter. Its value is `.value`.

        :raises ParameterNotDeclaredException: when the parameter is not declared.
        :raises ParameterUninitializedException: when the parameter was declared with a type only and has no value yet.
        """
        store = self._rclpy.parameters
        parameter: Parameter | None = store.values.get(name)
        if parameter is None:
            if store.allow_undeclared:
                return Parameter(name, Parameter.Type.NOT_SET, None)
            raise undeclared(name, store.values)
        if parameter.type_ is Parameter.Type.NOT_SET and not store.descriptors[name].dynamic_typing:
            raise ParameterUninitializedException(name)
        return parameter

    def get_parameters(self, names: list[str]) -> list[Parameter]:
        """Return several parameters. Raise TypeError unless all names are strings."""
        if not all(isinstance(name, str) for name in names):
            raise TypeError('All names must be instances of type str')
        return [self.get_parameter(name) for name in names]

    def get_parameter_or(self, name: str, alternative_value: Parameter | None = None) -> Parameter:
        """Return a parameter, or `alternative_value` (a Parameter) if the parameter is not declared or has no value."""
        parameter: Parameter | None = self._rclpy.parameters.values.get(name)
        if parameter is not None and parameter.type_ is not Parameter.Type.NOT_SET:
            return parameter
        return Parameter(name, Parameter.Type.NOT_SET) if alternative_value is None else alternative_value

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter]:
        """Return the parameters that begin with `prefix.`, by their names without this prefix."""
        prefix = prefix + PARAMETER_SEPARATOR_STRING if prefix else ''
        return {
            name[len(prefix) :]: parameter for name, parameter in self._rclpy.parameters.values.items() if name.startswith(prefix)
        }

    def get_parameter_type(self, name: str) -> int | Parameter.Type:
        """Return the type number of a parameter's value, or 0 without a value.

        As in rclpy, the result for an undeclared parameter (if allowed) is `Parameter.Type.NOT_SET` itself.
        """
        store = self._rclpy.parameters
        if name in store.values:
            return int(store.values[name].type_.value)
        if not store.allow_undeclared:
            raise undeclared(name, store.values)
        return Parameter.Type.NOT_SET

    def get_parameter_types(self, names: list[str]) -> list[int | Parameter.Type]:
        """Return the type numbers of several parameters."""
        if not all(isinstance(name, str) for name in names):
            raise TypeError('All names must be instances of type str')
        return [self.get_parameter_type(name) for name in names]

    def describe_parameter(self, name: str) -> ParameterDescriptor:
        """Return the descriptor of a parameter."""
        return self._rclpy.parameters.descriptor(name)

    def describe_parameters(self, names: list[str]) -> list[ParameterDescriptor]:
        """Return the descriptors of several parameters."""
        return [self.describe_parameter(name) for name in names]

    def list_parameters(self, prefixes: list[str], depth: int) -> ListParametersResult:
        """Return the names of parameters as a ListParametersResult.

        :param prefixes: return only names below one of these prefixes; an empty list selects all parameters.
        :param depth: the greatest number of levels below a prefix; 0 means no limit.
        :raises TypeError: if `prefixes` is not a list of strings, or `depth` is not an int.
        :raises ValueError: for a negative depth.
        """
        from rcl_interfaces.msg import ListParametersResult

        if not isinstance(prefixes, list):
            raise TypeError('The prefixes argument must be a list')
        if not all(isinstance(prefix, str) for prefix in prefixes):
            raise TypeError('All prefixes must be instances of type str')
        if not isinstance(depth, int):
            raise TypeError('The depth must be instance of type int')
        if depth < 0:
            raise ValueError('The depth must be greater than or equal to zero')
        names = [name for name in self._rclpy.parameters.values if _listed(name, prefixes, depth)]
        groups = {name.rpartition('.')[0] for name in names if '.' in name}
        return ListParametersResult(names=names, prefixes=sorted(groups))

    def set_parameters(self, parameter_list: list[Parameter]) -> list[SetParametersResult]:
        """Set each parameter separately. Return one result for each parameter.

        :raises ParameterNotDeclaredException: when a parameter is undeclared. The parameters before it have been set by then.
        """
        store = self._rclpy.parameters
        results = []
        for parameter in parameter_list:
            store.check_declared([parameter])
            results.append(store.set_atomically([parameter]))
        return results

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> SetParametersResult:
        """Set all parameters, or no parameter if one is rejected.

        :raises ParameterNotDeclaredException: when one of the parameters is undeclared.
        """
        self._rclpy.parameters.check_declared(parameter_list)
        return self._rclpy.parameters.set_atomically(parameter_list)

    def set_descriptor(
        self, name: str, descriptor: ParameterDescriptor, alternative_value: ParameterValue | None = None
    ) -> ParameterValue:
        """Set the descriptor of a parameter, and return the value. `alternative_value` replaces a value that the descriptor
        does not allow.

        :raises ParameterNotDeclaredException: when the parameter is not declared.
        :raises ParameterImmutableException: when the parameter is read-only.
        :raises InvalidParameterValueException: when the descriptor does not allow the value.
        """
        store = self._rclpy.parameters
        if name not in store.values:
            return self.get_parameter(name).get_parameter_value()
        if store.descriptors[name].read_only:
            raise ParameterImmutableException(name)
        parameter = self.get_parameter(name)
        descriptor.name = name
        problem = store.problem(parameter, descriptor, check_read_only=False)
        if problem is not None and alternative_value is not None:
            parameter = Parameter(name, value=parameter_value_to_python(alternative_value))
            problem = store.problem(parameter, descriptor, check_read_only=False)
        if problem is not None:
            raise InvalidParameterValueException(name, parameter.value, problem)
        store.descriptors[name] = descriptor
        store.values[name] = parameter
        return parameter.get_parameter_value()

    def add_pre_set_parameters_callback(self, callback: Callable[[list[Parameter]], list[Parameter]]) -> None:
        """Register `callback(parameters)`, which returns the list of parameters to set in place of the given list."""
        self._rclpy.parameters.pre_callbacks.insert(0, callback)

    def add_on_set_parameters_callback(self, callback: OnSet) -> None:
        """Register `callback(parameters)`, which accepts or rejects a change by returning a SetParametersResult. The newest
        callback is called first. Raise TypeError for an object that cannot be called.
        """
        _check_callable(callback)
        self._rclpy.parameters.on_callbacks.insert(0, callback)

    def add_post_set_parameters_callback(self, callback: Callable[[list[Parameter]], None]) -> None:
        """Register `callback(parameters)`, which is called after a successful change. Raise TypeError for an object that cannot
        be called.
        """
        _check_callable(callback)
        self._rclpy.parameters.post_callbacks.insert(0, callback)

    def remove_pre_set_parameters_callback(self, callback: Callable[[list[Parameter]], list[Parameter]]) -> None:
        """Unregister a callback that was added with `add_pre_set_parameters_callback`. Raise ValueError if it is not
        registered.
        """
        self._rclpy.parameters.pre_callbacks.remove(callback)

    def remove_on_set_parameters_callback(self, callback: OnSet) -> None:
        """Unregister a callback that was added with `add_on_set_parameters_callback`. Raise ValueError if it is not
        registered.
        """
        self._rclpy.parameters.on_callbacks.remove(callback)

    def remove_post_set_parameters_callback(self, callback: Callable[[list[Parameter]], None]) -> None:
        """Unregister a callback that was added with `add_post_set_parameters_callback`. Raise ValueError if it is not
        registered.
        """
        self._rclpy.parameters.post_callbacks.remove(callback)


def _check_callable(callback: object) -> None:
    if not callable(callback):
        raise TypeError('Callback must be callable, got {}', type(callback))  # [sic]: ROS 2 passes both to the error


def _prepared(
    overrides: Mapping[str, Override], namespace: str, index: int, entry: tuple[Any, ...]
) -> tuple[Parameter, ParameterDescriptor]:
    """Return the first value and the descriptor for one declaration."""
    name, value, descriptor = _unpacked(index, entry)
    name = f'{namespace}.{name}' if namespace else name
    if len(entry) == 1:
        warn(NAME_ONLY.format(name), stacklevel=student_level())
        descriptor.dynamic_typing = True
    if not name:
        raise InvalidParameterException(name)
    if isinstance(value, Parameter.Type):
        _set_type(name, descriptor, value)
        value = None
    elif not descriptor.dynamic_typing:
        is_message = type(value).__name__ == 'ParameterValue'  # rclpy uses its type, and later rejects it as a value
        descriptor.type = value.type if is_message else Parameter.Type.from_parameter_value(value).value
        if not descriptor.type:
            raise ValueError('Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET')
    if name in overrides:
        value = overrides[name].value
    descriptor.name = name
    return Parameter(name, value=value), descriptor


def _unpacked(index: int, entry: tuple[Any, ...]) -> tuple[str, Any, ParameterDescriptor]:
    """Return the name, value and descriptor of one entry of `declare_parameters`.

    As in rclpy, the descriptor is the given object, not a copy. A second declaration with it changes the type of the first one.
    """
    from rcl_interfaces.msg import ParameterDescriptor

    if not 1 <= len(entry) <= 3:
        raise TypeError(
            f'Invalid parameter tuple length at index {index} in parameters list: {entry}; expecting length between 1 and 3'
        )
    name = entry[0]
    if not isinstance(name, str):
        raise TypeError(f'First element {name} at index {index} in parameters list is not a str.')
    descriptor = entry[2] if len(entry) > 2 else ParameterDescriptor()
    if not isinstance(descriptor, ParameterDescriptor):
        raise TypeError(f'Third element {descriptor} at index {index} in parameters list is not a ParameterDescriptor.')
    return name, entry[1] if len(entry) > 1 else None, descriptor


def _set_type(name: str, descriptor: ParameterDescriptor, type_: Parameter.Type) -> None:
    if type_ is Parameter.Type.NOT_SET:
        raise ValueError(f'Cannot declare parameter {{{name}}} as statically typed of type NOT_SET')
    if descriptor.dynamic_typing:
        raise ValueError(
            f'When declaring parameter {{{name}}} passing a descriptor with`dynamic_typing=True` is not allowed '
            'when the parameter type is provided'
        )
    descriptor.type = type_.value


def _listed(name: str, prefixes: list[str], depth: int) -> bool:
    if not prefixes:
        return not depth or name.count('.') < depth
    for prefix in prefixes:
        if name == prefix or (name.startswith(prefix + '.') and (not depth or name[len(prefix) + 1 :].count('.') < depth)):
            return True
    return False
