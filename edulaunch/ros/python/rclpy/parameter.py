"""Parameters, and the functions that convert parameters from and to messages and YAML."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING, Any

from edulaunch.engine.graph import parameters as rules
from edulaunch.ros.passed_on import passed_on
from edulaunch.ros.read_only import ReadOnly

if TYPE_CHECKING:
    from rcl_interfaces.msg import Parameter as ParameterMsg
    from rcl_interfaces.msg import ParameterValue

PARAMETER_SEPARATOR_STRING = '.'

_VALUE_FIELDS = (
    '',
    'bool_value',
    'integer_value',
    'double_value',
    'string_value',
    'byte_array_value',
    'bool_array_value',
    'integer_array_value',
    'double_array_value',
    'string_array_value',
)


class Parameter:
    """A parameter with its name, type and value.

    :param name: the parameter's name.
    :param type_: the parameter's type; None means the type of the value.
    :raises TypeError: when no parameter can hold the value, or `type_` is not a `Parameter.Type`.
    :raises ValueError: when the type and the value do not agree.
    """

    class Type(Enum):
        """The types of parameters."""

        NOT_SET = rules.NOT_SET
        BOOL = rules.BOOL
        INTEGER = rules.INTEGER
        DOUBLE = rules.DOUBLE
        STRING = rules.STRING
        BYTE_ARRAY = rules.BYTE_ARRAY
        BOOL_ARRAY = rules.BOOL_ARRAY
        INTEGER_ARRAY = rules.INTEGER_ARRAY
        DOUBLE_ARRAY = rules.DOUBLE_ARRAY
        STRING_ARRAY = rules.STRING_ARRAY

        @classmethod
        def from_parameter_value(cls, parameter_value: Any) -> Parameter.Type:
            """Return the type of a value. A bool is not an integer, and an empty list is a BYTE_ARRAY.

            :raises TypeError: when no parameter can hold the value.
            """
            return cls(rules.type_of_value(parameter_value))

        def check(self, parameter_value: Any) -> bool:
            """Return whether a value is of this type."""
            return rules.value_fits(parameter_value, self.value)

    __slots__ = ('_name', '_type_', '_value')

    def __init__(self, name: str, type_: Parameter.Type | None = None, value: Any = None) -> None:
        if type_ is None:
            type_ = Parameter.Type.from_parameter_value(value)
        if not isinstance(type_, Parameter.Type):
            raise TypeError(f"type must be an instance of '{repr(Parameter.Type)}'")
        if not type_.check(value):
            raise ValueError(f"Type '{type_}' and value '{value}' do not agree")
        self._name = name
        self._type_ = type_
        self._value = value

    @classmethod
    def from_parameter_msg(cls, param_msg: Any) -> Parameter:
        """Return the Parameter for a rcl_interfaces/Parameter."""
        value = param_msg.value
        return cls(param_msg.name, Parameter.Type(value.type), getattr(value, _VALUE_FIELDS[value.type]) if value.type else None)

    name: ReadOnly[str] = ReadOnly('The name.', '_name')

    type_: ReadOnly[Parameter.Type] = ReadOnly('The type.', '_type_')

    value: ReadOnly[Any] = ReadOnly('The value; None when not set.', '_value')

    def get_parameter_value(self) -> ParameterValue:
        """Return the value as rcl_interfaces/ParameterValue. The field depends on the type (`string_value` ...)."""
        from rcl_interfaces.msg import ParameterValue

        number = self._type_.value
        message = ParameterValue()
        message.type = number
        if self._type_ is not Parameter.Type.NOT_SET:
            value = list(self._value) if isinstance(self._value, tuple) else self._value
            setattr(message, _VALUE_FIELDS[number], value)
        return message

    def to_parameter_msg(self) -> ParameterMsg:
        """Return the parameter as rcl_interfaces/Parameter."""
        from rcl_interfaces.msg import Parameter as ParameterMsg

        return ParameterMsg(name=self._name, value=self.get_parameter_value())


def parameter_value_to_python(parameter_value: Any) -> Any:
    """Return the Python value of a rcl_interfaces/ParameterValue. Arrays of numbers become lists. Raise RuntimeError for an
    unknown type.
    """
    number = parameter_value.type
    if number == rules.NOT_SET:
        return None
    if number >= len(_VALUE_FIELDS):
        raise RuntimeError(f'unexpected parameter type {number}')
    value = getattr(parameter_value, _VALUE_FIELDS[number])
    return list(value) if number >= rules.BYTE_ARRAY else value


def get_parameter_value(string_value: str) -> ParameterValue:
    """Return the value of a YAML 1.1 string (`off` is a bool, and `5` is an integer), as `ros2 param set` does.

    An empty list is a list of bools. A value that YAML cannot parse, or that no parameter can hold, stays a string.

    :raises yaml.scanner.ScannerError: when the string is not a valid YAML token, such as `@`. ROS 2 raises this error, too.
    """
    import yaml

    try:
        value = yaml.safe_load(string_value)
    except yaml.parser.ParserError:
        value = string_value
    if value == []:
        return Parameter('', Parameter.Type.BOOL_ARRAY, []).get_parameter_value()
    try:
        parameter = Parameter('', value=value)
    except TypeError:
        parameter = Parameter('', value=string_value)
    if parameter.type_ in (Parameter.Type.NOT_SET, Parameter.Type.BYTE_ARRAY):
        parameter = Parameter('', value=string_value)
    return parameter.get_parameter_value()


def parameter_dict_from_yaml_file(
    parameter_file: str, use_wildcard: bool = False, target_nodes: list[str] | None = None, namespace: str = ''
) -> dict[str, ParameterMsg]:
    """Return the parameters of a parameter file as messages, by name.

    If several nodes have a parameter, its last value is used. As in ROS 2, a parameter without a value becomes the string 'None'.

    :param use_wildcard: whether to include entries under `/**`.
    :param target_nodes: the full names of the nodes to include; None means all nodes in the file.
    :param namespace: a prefix for each name. As in ROS 2, it must end with a dot.
    :raises RuntimeError: when the file lacks one of the target nodes, or is not a parameter file.
    :raises AttributeError: when the file is not a mapping.
    """
    import yaml

    with open(parameter_file, encoding='utf-8') as file:
        content = yaml.safe_load(file)
    written_for = list(content.keys())
    keys = ['/**'] if use_wildcard and '/**' in content else []
    for key in target_nodes or ():
        if key not in content:
            raise RuntimeError(f'Param file does not contain parameters for {key},only for nodes: {written_for} ')
    keys += target_nodes or [key for key in written_for if key != '/**']
    if not keys:
        raise RuntimeError('Param file does not contain selected parameters')
    found: dict[str, Any] = {}
    for key in keys:
        body = content[key]
        if not isinstance(body, dict) or 'ros__parameters' not in body:
            raise RuntimeError(f'YAML file is not a valid ROS parameter file for node {key}')
        found.update(_flattened(body['ros__parameters'], namespace))
    return {name: Parameter(name, value='None' if value is None else value).to_parameter_msg() for name, value in found.items()}


def _flattened(values: dict[str, Any], prefix: str) -> dict[str, Any]:
    flat: dict[str, Any] = {}
    for name, value in values.items():
        if isinstance(value, dict):
            flat.update(_flattened(value, f'{prefix}{name}{PARAMETER_SEPARATOR_STRING}'))
        else:
            flat[prefix + name] = value
    return flat


__getattr__ = passed_on(__name__)
