"""The type description, the hash and the source of a type, as C structures. `~/get_type_description` returns them."""

from __future__ import annotations

import ctypes as c
from collections.abc import Sequence as Rows
from typing import Any

from edulaunch.engine.interfaces.registry import Registry
from edulaunch.extras.native.typesupport import abi
from edulaunch.ros.serialization.type_description import type_description, type_hash


def described(type_name: str, registry: Registry) -> tuple[int, int, int]:
    """Return three C functions that return the hash, the description and the sources of a type."""
    version, _, digits = type_hash(type_name, registry.spec).partition('_')
    data = type_description(type_name, registry.spec)
    names = [type_name, *(each['type_name'] for each in data['referenced_type_descriptions'])]
    made = (
        abi.Hash(int(version.removeprefix('RIHS')), (c.c_uint8 * 32)(*bytes.fromhex(digits))),
        abi.Description(
            _one(data['type_description']), _sequence(map(_one, data['referenced_type_descriptions']), abi.DescribedOne)
        ),
        _sequence((_source(name, registry) for name in names), abi.TypeSource),
    )
    return tuple(_giving(each) for each in made)  # type: ignore[return-value]


def _giving(structure: Any) -> int:
    where = c.addressof(abi.keep(structure))
    return abi.address_of(abi.keep(abi.GIVES_ADDRESS(lambda support: where)))


def _string(text: str) -> abi.String:
    data = text.encode()
    return abi.String(data, len(data), len(data) + 1)


def _sequence(items: Any, kind: Any) -> abi.Sequence:
    rows: Rows[Any] = list(items)
    if not rows:
        return abi.Sequence(None, 0, 0)
    array = abi.keep((kind * len(rows))(*rows))
    return abi.Sequence(c.addressof(array), len(rows), len(rows))


def _one(data: dict[str, Any]) -> abi.DescribedOne:
    return abi.DescribedOne(_string(data['type_name']), _sequence(map(_field, data['fields']), abi.DescribedField))


def _field(data: dict[str, Any]) -> abi.DescribedField:
    kind = data['type']
    described = abi.DescribedType(kind['type_id'], kind['capacity'], kind['string_capacity'], _string(kind['nested_type_name']))
    return abi.DescribedField(_string(data['name']), described, _string(''))


def _source(type_name: str, registry: Registry) -> abi.TypeSource:
    """Return the content of a type's file. A part of a service or action has no file of its own."""
    is_part = '_' in type_name.rpartition('/')[2]
    text = '' if is_part else registry.text(type_name)
    return abi.TypeSource(_string(type_name), _string('implicit' if is_part else type_name.split('/')[1]), _string(text))
