"""Evaluates the parameters of a node at launch time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.substitution import Substitution
from launch.utilities._yaml_values import load_yaml_value
from launch.utilities.texts import perform_substitutions
from launch.utilities.type_utils import ensure_argument_type

from edulaunch.engine.facts import with_facts

from ..parameter_descriptions import ParameterFile, ParameterValue
from ..parameters_type import EvaluatedParameters, EvaluatedParameterValue, Parameters, ParametersDict

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


_SCALARS = (bool, int, float, str, bytes)


_ITEMS = (bool, int, float, str)


_AS_YAML = 'launch.value-as-yaml'


_WRAP = (
    'If the parameter is meant to be a string, try wrapping it in '
    'launch_ros.parameter_descriptions.ParameterValue(value, value_type=str)'
)


def evaluate_parameters(context: LaunchContext, parameters: Parameters) -> EvaluatedParameters:
    """Return the evaluated parameters in order: paths, dicts of plain values, and Parameter objects.

    Lists of values become tuples, except the lists of a ParameterValue.

    :param parameters: the result of :func:`~launch_ros.utilities.normalize_parameters`.
    :raises TypeError: for a value that no ROS parameter can have. The message names the parameter.
    """
    return tuple([_evaluate(context, item) for item in parameters])


def _evaluate(context: LaunchContext, item: Any) -> Any:
    if isinstance(item, ParameterFile):
        return item.evaluate(context)
    return evaluate_parameter_dict(context, item) if isinstance(item, dict) else item


def evaluate_parameter_dict(context: LaunchContext, parameters: ParametersDict) -> dict[str, EvaluatedParameterValue]:
    """Return the names and values of one normalized dict."""
    evaluated = {}
    for substitutions, value in parameters.items():
        name = perform_substitutions(context, substitutions)
        evaluated[name] = _evaluate_value(context, name, value)
    return evaluated


def _evaluate_value(context: LaunchContext, name: str, value: Any) -> Any:
    if isinstance(value, ParameterValue):
        try:
            return value.evaluate(context)
        except ValueError as error:
            if 'using yaml rules' in str(error):
                with_facts(error, _AS_YAML, parameter=name)
            raise
    if not isinstance(value, tuple) or not value:
        ensure_argument_type(value, (float, int, str, bool, bytes), 'value')
        return value
    if isinstance(value[0], Substitution):
        return _typed(name, perform_substitutions(context, value))
    return _uniform(name, [_typed_item(context, name, item) for item in value])


def _typed_item(context: LaunchContext, name: str, item: Any) -> Any:
    return _typed(name, perform_substitutions(context, item)) if isinstance(item, list) else item


def _typed(name: str, text: str) -> Any:
    """Convert a string by YAML's rules."""
    if not text:
        return ''
    value = _load(name, text)
    if isinstance(value, list):
        return _uniform(name, value)
    if not isinstance(value, _SCALARS):
        raise TypeError(
            'Allowed value types are bytes, bool, int, float, str, '
            'Sequence[bool], Sequence[int], Sequence[float], '
            f'Sequence[str]. Got {type(value)} for "{name}". {_WRAP}'
        )
    return value


def _load(name: str, text: str) -> Any:
    try:
        return load_yaml_value(text)
    except Exception as error:
        import yaml

        if not isinstance(error, (yaml.YAMLError, ValueError)):
            raise
        unread = TypeError(f'Unable to parse the value of parameter {name} as yaml. {_WRAP}')
        raise with_facts(unread, _AS_YAML, parameter=name) from None


def _uniform(name: str, items: list[Any]) -> tuple[Any, ...]:
    """Return the items as a tuple, if there are any and all have the type of the first item. Otherwise, return None.

    True counts as an int, as in Python.
    """
    kind = type(items[0]) if items else None
    if kind not in _ITEMS or not all(isinstance(item, kind) for item in items):
        raise TypeError(
            'Expected a non-empty sequence, with items of uniform type. '
            'Allowed sequence item types are bool, int, '
            f'float, str. Got inconsistent input for "{name}"'
        )
    return tuple(items)
