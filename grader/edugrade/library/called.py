"""Calls functions and classes that a notebook cell defines, and reports exceptions as failures of a check."""

from __future__ import annotations

from typing import Any

from ..evidence import Evidence, Failure, Mismatch, Missing
from ..shortened import shortened

LONGEST_VALUE = 500
_ANY = object()


def defined(run: Evidence, name: str) -> Any:
    """Return the value of a name that a notebook cell defines.

    :raises Missing: if no cell defines the name.
    """
    if name not in run.names:
        raise Missing(name, name=name, among=run.names, try_=f'run the cell that defines {name}')
    return run.names[name]


def call(name: str, function: Any, *given: Any, wanted: Any = _ANY) -> Any:
    """Call a function or a class of the student, and return the result.

    :param name: the name of the function or class, for the report.
    :param function: the function or class.
    :param given: the arguments of the call.
    :param wanted: the expected result (default: any result).
    :raises Failure: if the object cannot be called, or the call raises an exception.
    :raises Mismatch: if the result differs from `wanted`.
    """
    words = f'{name}({", ".join(getattr(value, "__name__", None) or repr(value) for value in given)})'
    if not callable(function):
        raise Failure(f'{words} cannot be called', seen=f'{name} is {function!r}', try_=f'define {name} with def or with class')
    try:
        found = function(*given)
    except Exception as error:  # the code of the student may raise any exception
        raise Failure(
            f'{words} raises {type(error).__name__}', seen=str(error) or 'no message', try_=f'call {name} in a cell of your own'
        ) from None
    if wanted is not _ANY and found != wanted:
        seen = shortened(repr(found), LONGEST_VALUE)
        raise Mismatch(f'the return value of {words}', repr(wanted), seen, try_=f'call {name} in a cell of your own')
    return found
