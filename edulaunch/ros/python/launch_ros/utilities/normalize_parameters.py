"""Converts the parameters of a node to one form."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from launch.substitution import SomeSubstitutionsType_types_tuple, Substitution
from launch.utilities.texts import normalize_to_list_of_substitutions
from launch.utilities.type_utils import ensure_argument_type

from ..parameter_descriptions import Parameter, ParameterFile, ParameterValue
from ..parameters_type import Parameters, ParametersDict, SomeParameters, SomeParametersDict

_LITERALS = (str, bool, int, float, bytes, ParameterValue)


_ITEM_TYPES = (float, int, str, bool, *SomeSubstitutionsType_types_tuple)


def normalize_parameters(parameters: SomeParameters) -> Parameters:
    """Return the parameters as a list of parameter files, dicts and Parameter objects.

    :raises TypeError: when `parameters` is not a list, or an item or a value has an unsupported type.
    """
    if isinstance(parameters, str) or not isinstance(parameters, Sequence):
        raise TypeError(f'Expecting list of parameters, got {parameters}')
    return [_normalize(item) for item in parameters]


def _normalize(item: Any) -> Any:
    if isinstance(item, (dict, Mapping)):  # checking for a dict is faster than for a Mapping
        return normalize_parameter_dict(item)
    return item if isinstance(item, (ParameterFile, Parameter)) else ParameterFile(item)


def normalize_parameter_dict(parameters: SomeParametersDict, *, _prefix: Sequence[Substitution] = ()) -> ParametersDict:
    """Return one mapping as a flat dict. Nested names are joined with '.', and an empty nested mapping is left out.

    :raises TypeError: for a value of an unsupported type.
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
