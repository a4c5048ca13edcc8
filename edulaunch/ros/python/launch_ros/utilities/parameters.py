"""Parameters of nodes: normalized, evaluated, and as descriptions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from launch._lazy import has_ros_paths
from launch.substitution import SomeSubstitutionsType_types_tuple, Substitution
from launch.utilities._yaml_values import load_yaml_value
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from launch.utilities.type_utils import ensure_argument_type

from ..parameter_descriptions import Parameter, ParameterFile, ParameterValue
from ..parameters_type import (
    EvaluatedParameters,
    EvaluatedParameterValue,
    Parameters,
    ParametersDict,
    SomeParameters,
    SomeParametersDict,
)

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

_LITERALS = (str, bool, int, float, bytes, ParameterValue)
_ITEM_TYPES = (float, int, str, bool, *SomeSubstitutionsType_types_tuple)


def normalize_parameters(parameters: SomeParameters) -> Parameters:
    """A list of parameter files, dicts and Parameters.

    :raises TypeError: when it is not a list, or an item or value is of no kind that can be used.
    """
    if isinstance(parameters, str) or not isinstance(parameters, Sequence):
        raise TypeError(f'Expecting list of parameters, got {parameters}')
    return [_normalize(item) for item in parameters]


def _normalize(item: Any) -> Any:
    if isinstance(item, (dict, Mapping)):  # a dict is known sooner than a Mapping
        return normalize_parameter_dict(item)
    return item if isinstance(item, (ParameterFile, Parameter)) else ParameterFile(item)


def normalize_parameter_dict(parameters: SomeParametersDict, *, _prefix: Sequence[Substitution] = ()) -> ParametersDict:
    """A flat dict of one mapping: nested names are joined with '.', and an empty nested mapping vanishes.

    :raises TypeError: for a value of no kind that can be used.
    """
    if not isinstance(parameters, dict):
        ensure_argument_type(parameters, Mapping, 'parameters')
    normalized: ParametersDict = {}
    for name, value in parameters.items():
        if not isinstance(name, (str, tuple)):
            ensure_argument_type(name, SomeSubstitutionsType_types_tuple, 'name')
        full_name = (*_prefix, *normalize_to_list_of_substitutions(name))
        if isinstance(value, _LITERALS):
            normalized[full_name] = value
        elif isinstance(value, Mapping):
            normalized.update(normalize_parameter_dict(value, _prefix=(*full_name, *normalize_to_list_of_substitutions('.'))))
        else:
            normalized[full_name] = _normalize_value(value)
    return normalized


def _normalize_value(value: Any) -> Any:
    if isinstance(value, Substitution):
        return (value,)
    if isinstance(value, Sequence):
        return _normalize_list(value)
    raise TypeError(f'Unexpected type for parameter value {value}')


def _normalize_list(items: Iterable[Any]) -> Any:
    items = list(items)
    for item in items:
        ensure_argument_type(item, _ITEM_TYPES, 'subvalue')
    kinds = {_kind(item) for item in items}
    if kinds <= {Substitution, str} and Substitution in kinds:
        return tuple(normalize_to_list_of_substitutions(items))
    if kinds == {float, int}:
        return tuple(float(item) for item in items)
    return tuple(normalize_to_list_of_substitutions(item) if _kind(item) in (Substitution, list) else item for item in items)


def _kind(item: Any) -> type:
    for kind in (Substitution, str, bool, int, float):
        if isinstance(item, kind):
            return kind
    return list


_SCALARS = (bool, int, float, str, bytes)
_ITEMS = (bool, int, float, str)
_WRAP = (
    'If the parameter is meant to be a string, try wrapping it in '
    'launch_ros.parameter_descriptions.ParameterValue(value, value_type=str)'
)


def evaluate_parameters(context: LaunchContext, parameters: Parameters) -> EvaluatedParameters:
    """Paths, dicts of plain values (lists become tuples), and Parameters, in order.

    :param parameters: what :func:`~launch_ros.utilities.normalize_parameters` returned.
    :raises TypeError: for a value that no ROS parameter can have; it names the parameter.
    """
    return tuple([_evaluate(context, item) for item in parameters])


def _evaluate(context: LaunchContext, item: Any) -> Any:
    if isinstance(item, ParameterFile):
        return item.evaluate(context)
    return evaluate_parameter_dict(context, item) if isinstance(item, dict) else item


def evaluate_parameter_dict(context: LaunchContext, parameters: ParametersDict) -> dict[str, EvaluatedParameterValue]:
    """Names and values of one normalized dict."""
    evaluated = {}
    for substitutions, value in parameters.items():
        name = perform_substitutions(context, substitutions)
        evaluated[name] = _evaluate_value(context, name, value)
    return evaluated


def _evaluate_value(context: LaunchContext, name: str, value: Any) -> Any:
    if isinstance(value, ParameterValue):
        given = value.evaluate(context)
        return tuple(given) if isinstance(given, list) else given
    if not isinstance(value, tuple) or not value:
        ensure_argument_type(value, (float, int, str, bool, bytes), 'value')
        return value
    if isinstance(value[0], Substitution):
        return _typed(name, perform_substitutions(context, value))
    return _uniform(name, [_typed_item(context, name, item) for item in value])


def _typed_item(context: LaunchContext, name: str, item: Any) -> Any:
    return _typed(name, perform_substitutions(context, item)) if isinstance(item, list) else item


def _typed(name: str, text: str) -> Any:
    """A text by YAML's rules."""
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
        raise TypeError(f'Unable to parse the value of parameter {name} as yaml. {_WRAP}') from None


def _uniform(name: str, items: list[Any]) -> tuple[Any, ...]:
    """The items as a tuple, if there are any and all have the type of the first (True passes for an int, as
    in Python)."""
    kind = type(items[0]) if items else None
    if kind not in _ITEMS or not all(isinstance(item, kind) for item in items):
        raise TypeError(
            'Expected a non-empty sequence, with items of uniform type. '
            'Allowed sequence item types are bool, int, '
            f'float, str. Got inconsistent input for "{name}"'
        )
    return tuple(items)


has_ros_paths(__name__)
