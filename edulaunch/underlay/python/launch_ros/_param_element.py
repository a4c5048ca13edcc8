"""`<param name= value= type=/>`, `<param from= allow_substs=/>`, and `<param name=>` with others inside."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.frontend import places
from launch.frontend.entity import Entities, Entity, Pair
from launch.utilities.type_utils import ListTypesTuple, ScalarTypesTuple

from .parameter_descriptions import ParameterFile, ParameterValue

if TYPE_CHECKING:
    from launch.frontend.parser import Parser

_SCALARS = ('int', 'float', 'bool', 'str')
_TYPES: dict[str, Any] = {
    **dict(zip(_SCALARS, ScalarTypesTuple, strict=True)),
    **{f'list_of_{name}': data_type for name, data_type in zip(_SCALARS, ListTypesTuple, strict=True)},
    'yaml': None,
}
_WHICH = frozenset(('name', 'from', 'allow_substs'))
_WHAT = frozenset(('value', 'type'))
_INSIDE = frozenset(('param',))


def parameters_in(entity: Entity, parser: Parser, tag: str) -> list[Any]:
    """The argument `parameters` of a node: one source for each element, in the order of the file, so that later ones win.

    :raises RuntimeError, ValueError: for attributes that do not go together.
    """
    plain = entity.plain_pairs(tag, 'name', 'value', is_typed=True)
    if plain is not None:
        return [_plain_dictionary([pair], parser) for pair in plain]
    parameters: list[Any] = []
    for param in entity.get_attr(tag, data_type=Entities):
        given = param.given(_WHICH)
        if 'from' in given:
            parameters.append(_file(param, given, parser))
        elif 'allow_substs' in given:
            raise _wrong(param, "'allow_substs' can only be used together with 'from' attribute")
        elif 'name' in given:
            parameters.append(_dictionary([param], parser))
        else:
            raise places.at(ValueError('param Entity should have name or from attribute'), param, 'launch.param-element')
    return parameters


def _file(param: Entity, given: list[str], parser: Parser) -> ParameterFile:
    if 'name' in given:
        raise _wrong(param, 'name and from attributes are mutually exclusive')
    param.assert_entity_completely_parsed()
    path = parser.parse_substitution(param.get_attr('from'))
    allow_substs = param.get_attr('allow_substs', data_type=bool) if 'allow_substs' in given else False
    return ParameterFile(path, allow_substs=parser.parse_if_substitutions(allow_substs))


def _plain_dictionary(pairs: list[Pair], parser: Parser) -> dict[Any, Any]:
    parse, parse_typed = parser.parse_substitution, parser.parse_if_substitutions
    return {tuple(parse(name)): _made(line, parse_typed(value), None) for name, value, line in pairs}


def _dictionary(params: list[Entity], parser: Parser) -> dict[Any, Any]:
    return {tuple(parser.parse_substitution(param.get_attr('name'))): _value(param, parser) for param in params}


def _made(line: int, value: Any, data_type: Any) -> ParameterValue:
    made = ParameterValue(value, value_type=data_type)
    made.line = line
    return made


def _value(param: Entity, parser: Parser) -> Any:
    given = param.given(_WHAT, _INSIDE)
    data_type = _data_type(param) if 'type' in given else None
    if 'param' in given:
        for name in ('value', 'type'):
            if name in given:
                raise _wrong(param, f'nested parameters and {name} attributes are mutually exclusive')
        param.assert_entity_completely_parsed()
        plain = param.plain_pairs('param', 'name', 'value', is_typed=True)
        if plain is not None:
            return _plain_dictionary(plain, parser)
        return _dictionary(param.get_attr('param', data_type=Entities), parser)
    if 'value' not in given:
        error = RuntimeError('either a value attribute or nested params are needed')
        raise places.at(error, param, 'launch.missing-attribute', needed='value', given_names=[])
    value = parser.parse_if_substitutions(param.get_attr('value', data_type=data_type))
    param.assert_entity_completely_parsed()
    return _made(param.line, value, data_type)


def _data_type(param: Entity) -> Any:
    name = param.get_attr('type')
    if name not in _TYPES:
        error = ValueError(f'Got invalid type identifier {name!r}')
        raise places.at(error, param, 'launch.only-value', attribute='type', allowed=list(_TYPES))
    return _TYPES[name]


def _wrong(param: Entity, message: str) -> RuntimeError:
    return places.at(RuntimeError(message), param)
