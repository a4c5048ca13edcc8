"""Typed values: int, float, bool, str and uniform lists of these types, as literals or substitutions.

Parameter values, typed arguments of actions, and the XML and YAML frontends use them.
"""

from __future__ import annotations

import collections.abc
import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, List, Union  # noqa: UP035

from ..substitution import Substitution
from ._yaml_values import YAML_BOOLEANS, load_yaml_value
from .texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..launch_context import LaunchContext

ScalarTypesTuple = (int, float, bool, str)
# These are typing.List, as in upstream, because error messages show them.
ListTypesTuple = (List[int], List[float], List[bool], List[str])  # noqa: UP006
AllowedTypesTuple = ScalarTypesTuple + ListTypesTuple

AllowedTypesType = Any
"""One of :data:`AllowedTypesTuple`."""
AllowedValueType = int | float | bool | str | list[int] | list[float] | list[bool] | list[str]
SomeValueType = Any
"""An allowed value, an object that contains substitutions, or a list of such objects."""
NormalizedValueType = Any
"""The result of :func:`normalize_typed_substitution`."""
StrSomeValueType = Any


def is_typing_list(data_type: AllowedTypesType) -> bool:
    """Return whether a type is `List[...]`, `List` or `list[...]`."""
    return getattr(data_type, '__origin__', None) is list or data_type is List  # noqa: UP006


def extract_type(data_type: AllowedTypesType) -> tuple[type, bool]:
    """Return the scalar type, and whether the given type was a list of that type.

    :raises ValueError: when `data_type` is not one of :data:`AllowedTypesTuple`.
    """
    is_list = is_typing_list(data_type)
    scalar_type = (getattr(data_type, '__args__', None) or (None,))[0] if is_list else data_type
    if scalar_type not in ScalarTypesTuple:
        raise ValueError(f'Unrecognized data type: {data_type}')
    return scalar_type, is_list


def is_valid_scalar_type(data_type: Any) -> bool:
    """Return whether a type is one of :data:`ScalarTypesTuple`."""
    return data_type in ScalarTypesTuple


def is_instance_of_valid_type(value: Any, can_be_str: bool = False) -> bool:
    """Return whether the value is a scalar of an allowed type, or a list whose items all have the same allowed type.

    :param can_be_str: whether items of a list may also be strings.
    """
    if not isinstance(value, list):
        return isinstance(value, ScalarTypesTuple)
    types = {type(item) for item in value}
    if can_be_str:
        types.discard(str)
    return len(types) <= 1 and all(one in ScalarTypesTuple for one in types)


def is_instance_of(value: Any, data_type: AllowedTypesType, can_be_str: bool = False) -> bool:
    """Return whether the value has the type. The type None means any allowed type. As in Python, True counts as an int.

    :param can_be_str: whether a string (or, in a list, strings) is also accepted.
    :raises ValueError: for a type that is not allowed.
    """
    if data_type is None:
        return is_instance_of_valid_type(value, can_be_str)
    scalar_type, is_list = extract_type(data_type)
    accepted = (scalar_type, str) if can_be_str else (scalar_type,)
    if not is_list:
        return isinstance(value, accepted)
    return isinstance(value, list) and all(isinstance(item, accepted) for item in value)


def coerce_to_type(value: str, data_type: AllowedTypesType = None, can_be_str: bool = False) -> AllowedValueType:
    """Convert a string to a value of a type.

    :param data_type: the type. None means that YAML's rules determine the type.
    :param can_be_str: whether to return the string itself if it cannot be converted. A list may then contain strings as well.
    :raises TypeError: when `value` is not a string.
    :raises ValueError: when the string cannot be converted.
    """
    if not isinstance(value, str):
        raise TypeError(f"value='{value}' is not a string, it is a {type(value)}")
    try:
        converted: AllowedValueType = _convert(value, data_type, can_be_str)
        return converted
    except ValueError:
        if can_be_str:
            return value
        raise


def _convert(value: str, data_type: AllowedTypesType, can_be_str: bool) -> Any:
    if data_type is None:
        return _convert_by_yaml(value, can_be_str)
    scalar_type, is_list = extract_type(data_type)
    if is_list:
        return _convert_to_list(value, scalar_type, can_be_str)
    return _convert_to_bool(value) if scalar_type is bool else scalar_type(value)


def _convert_to_bool(value: str) -> bool:
    text = value.strip()
    if text in ('1', '0'):
        return text == '1'
    if text in YAML_BOOLEANS:
        return YAML_BOOLEANS[text]
    raise ValueError(f"Cannot convert value '{value}' to '{bool}'")


def _convert_by_yaml(value: str, can_be_str: bool) -> Any:
    if value == '':
        return ''
    output = _load(value, f"Failed to convert '{value}' using yaml rules")
    if not is_instance_of_valid_type(output, can_be_str):
        raise ValueError(f"Failed to convert '{value}' using yaml rules: output type is not allowed, got {type(output)}")
    return output


def _convert_to_list(value: str, item_type: type, can_be_str: bool) -> list[Any]:
    output = _load(value, f"Cannot convert value '{value}' to a list of '{item_type}'")
    # The type must be equal: in a list of numbers, 1 is not a float, and true is not an int.
    accepted = (item_type, str) if can_be_str else (item_type,)
    if not isinstance(output, list) or any(type(item) not in accepted for item in output):
        raise ValueError(f"Cannot convert value '{value}' to a list of '{item_type}', got {output}")
    return output


def _load(value: str, message: str) -> Any:
    import yaml

    try:
        return load_yaml_value(value)
    except (yaml.YAMLError, RecursionError) as error:
        raise ValueError(f'{message}: {error}') from None


def coerce_list(value: list[str], data_type: AllowedTypesType = None, can_be_str: bool = False) -> list[Any]:
    """Convert each string of a list to a value of a type.

    :param data_type: the type of the items, or None for YAML's rules.
    :raises TypeError: when `value` is not a list of strings.
    :raises ValueError: when an item cannot be converted, or when the results differ in type without a `data_type`.
    """
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        raise TypeError(f"value='{value}' is not a list of strings")
    output = [coerce_to_type(item, data_type, can_be_str) for item in value]
    if not is_instance_of_valid_type(output, can_be_str):
        raise ValueError(f"cannot convert value '{value}' to a list of one type, got {output}")
    return output


def get_typed_value(value: str | list[str], data_type: AllowedTypesType, can_be_str: bool = True) -> Any:
    """Convert a string or a list of strings; see :func:`coerce_to_type` and :func:`coerce_list`.

    :raises TypeError: when a list is given for a scalar type, or when the value is neither a string nor a list.
    """
    if not isinstance(value, list):
        return coerce_to_type(value, data_type, can_be_str)
    item_type, is_list = (None, True) if data_type is None else extract_type(data_type)
    if not is_list:
        raise TypeError(f"value='{value}' is a list, and cannot be converted to '{data_type}'")
    return coerce_list(value, item_type, can_be_str)


def is_substitution(x: Any) -> bool:
    """Return whether a value is a substitution, or an iterable of substitutions and strings with at least one substitution."""
    if isinstance(x, Substitution):
        return True
    if isinstance(x, str) or not isinstance(x, collections.abc.Iterable):
        return False
    items = list(x)
    return any(isinstance(item, Substitution) for item in items) and all(isinstance(item, (str, Substitution)) for item in items)


def is_normalized_substitution(x: Any) -> bool:
    """Return whether a value is a non-empty list that contains only substitutions."""
    return isinstance(x, list) and bool(x) and all(isinstance(item, Substitution) for item in x)


def normalize_typed_substitution(value: SomeValueType, data_type: AllowedTypesType) -> NormalizedValueType:
    """Check the type of a value as far as possible before launch time, and return the value in its normal form.

    A scalar does not change. A substitution, or a list of strings and substitutions, becomes one value: a list of substitutions.
    Any other list is a list value, and each of its items is normalized separately.

    :raises TypeError: when a literal does not have the type.
    """
    if type(value) is data_type:
        return value
    if isinstance(value, ScalarTypesTuple):
        return _checked(value, data_type)
    if is_substitution(value):
        return normalize_to_list_of_substitutions(value)
    if not isinstance(value, collections.abc.Iterable):
        raise TypeError(f"value='{value}' is not an instance of {data_type}")
    items = [normalize_to_list_of_substitutions(item) if is_substitution(item) else item for item in value]
    literals = [item for item in items if not is_normalized_substitution(item)]
    if data_type is None or is_typing_list(data_type):
        _checked(literals, data_type)
        return items
    raise TypeError(f"value='{value}' is not an instance of {data_type}")


def perform_typed_substitution(
    context: LaunchContext, value: NormalizedValueType, data_type: AllowedTypesType
) -> AllowedValueType:
    """Evaluate the result of :func:`normalize_typed_substitution`.

    :raises TypeError: when a literal does not have the type.
    :raises ValueError: when the string of a substitution cannot be converted, or the items of a list differ in type.
    """
    if type(value) is data_type:
        return value  # type: ignore[no-any-return]
    if is_normalized_substitution(value):
        return coerce_to_type(perform_substitutions(context, value), data_type)
    if isinstance(value, list):
        return _perform_list(context, value, data_type)
    if data_type is not None:
        _checked(value, data_type)
    return value  # type: ignore[no-any-return]


def _perform_list(context: LaunchContext, value: list[Any], data_type: AllowedTypesType) -> AllowedValueType:
    item_type = extract_type(data_type)[0] if data_type is not None else None
    output: Any = [
        coerce_to_type(perform_substitutions(context, item), item_type) if is_normalized_substitution(item) else item
        for item in value
    ]
    return _checked(output, data_type, ValueError)  # type: ignore[no-any-return]


def _checked(value: Any, data_type: AllowedTypesType, error: type[Exception] = TypeError) -> Any:
    if not is_instance_of(value, data_type):
        raise error(f"value='{value}' is not an instance of {data_type}")
    return value


def ensure_argument_type(argument: Any, types: type | Iterable[type], argument_name: str, caller: str | None = None) -> None:
    """Check that `argument` is an instance of one of `types`.

    :param caller: the function or class named in the message.
    :raises TypeError: when the type is wrong. The message contains the caller, the argument, the expected types and the actual
        type.
    """
    expected = types if isinstance(types, tuple) else (types,) if isinstance(types, type) else tuple(types)
    if isinstance(argument, expected):
        return
    start = 'Expected' if caller is None else f"'{caller}' expected"
    shown = ', '.join(str(one) for one in expected)
    raise TypeError(f"{start} '{argument_name}' to be one of [{shown}], but got '{argument}' of type '{type(argument)}'")


def isclassinstance(obj: Any) -> bool:
    """Return whether `obj` is an instance of a class. The result is always true. The function exists for code from Python 2."""
    return hasattr(obj, '__class__')


def is_a(obj: Any, entity_type: Any) -> bool:
    """Return whether `obj` is an instance of `entity_type` or of a subclass."""
    return isinstance(obj, entity_type)


def is_a_subclass(obj: Any, entity_type: Any) -> bool:
    """Return whether `obj` is an instance of `entity_type`, or a class derived from it."""
    return isinstance(obj, entity_type) or (isinstance(obj, type) and issubclass(obj, entity_type))


FilePath = Union[bytes, str, 'os.PathLike[str]']
