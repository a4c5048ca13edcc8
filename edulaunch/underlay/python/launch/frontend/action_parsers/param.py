"""`<param name= value= type=/>`, `<param from= allow_substs=/>`, and `<param name=>` with others inside."""
from __future__ import annotations

from typing import Any

from launch.utilities.type_utils import ListTypesTuple, ScalarTypesTuple
from launch_ros.parameter_descriptions import ParameterFile, ParameterValue

from .. import hints
from ..entity import Entities, Entity
from ..parser import Parser

_SCALARS = ('int', 'float', 'bool', 'str')
_TYPES: dict[str, Any] = {
    **dict(zip(_SCALARS, ScalarTypesTuple, strict=True)),
    **{f'list_of_{name}': data_type for name, data_type in zip(_SCALARS, ListTypesTuple, strict=True)},
    'yaml': None}


def parameters_of(params: list[Entity], parser: Parser) -> list[Any]:
    """The argument `parameters` of a node: the files; then, as upstream, all named parameters in one dict.

    :raises RuntimeError, ValueError: for attributes that do not go together.
    """
    parameters: list[Any] = []
    named = []
    for param in params:
        from_text = param.get_attr('from', optional=True)
        allow_substs = param.get_attr('allow_substs', data_type=bool, optional=True)
        name = param.get_attr('name', optional=True)
        if from_text is not None and name is not None:
            raise _wrong(param, 'name and from attributes are mutually exclusive')
        if from_text is None and allow_substs is not None:
            raise _wrong(param, "'allow_substs' can only be used together with 'from' attribute")
        if from_text is not None:
            parameters.append(_file(param, from_text, allow_substs, parser))
        elif name is not None:
            named.append(param)
        else:
            raise hints.at(ValueError('param Entity should have name or from attribute'), param, None)
    if named:
        parameters.append(_dictionary(named, parser))
    return parameters


def _file(param: Entity, from_text: str, allow_substs: Any, parser: Parser) -> ParameterFile:
    param.assert_entity_completely_parsed()
    if isinstance(allow_substs, str):
        allow_substs = parser.parse_substitution(allow_substs)
    return ParameterFile(parser.parse_substitution(from_text), allow_substs=allow_substs or False)


def _dictionary(params: list[Entity], parser: Parser) -> dict[Any, Any]:
    return {
        tuple(parser.parse_substitution(param.get_attr('name'))): _value(param, parser) for param in params}


def _value(param: Entity, parser: Parser) -> Any:
    type_name = param.get_attr('type', optional=True)
    if type_name is not None and type_name not in _TYPES:
        error = ValueError(f'Got invalid type identifier {type_name!r}')
        raise hints.at(error, param, f"the types are {', '.join(_TYPES)}")
    data_type = None if type_name is None else _TYPES[type_name]
    value = param.get_attr('value', data_type=data_type, optional=True)
    nested = param.get_attr('param', data_type=Entities, optional=True)
    param.assert_entity_completely_parsed()
    if nested is not None:
        if value is not None:
            raise _wrong(param, 'nested parameters and value attributes are mutually exclusive')
        if data_type is not None:
            raise _wrong(param, 'nested parameters and type attributes are mutually exclusive')
        return _dictionary(nested, parser)
    if value is None:
        raise _wrong(param, 'either a value attribute or nested params are needed')
    return ParameterValue(parser.parse_if_substitutions(value), value_type=data_type)


def _wrong(param: Entity, message: str) -> RuntimeError:
    return hints.at(RuntimeError(message), param, None)
