"""Call functions and classes that a notebook cell defines, and report exceptions as sentences."""

from __future__ import annotations

from typing import Any

from ..evidence import Evidence, Failure, Mismatch, Missing
from ..shortened import shortened

LONGEST_VALUE = 500
_ANY = object()


def defined(run: Evidence, name: str) -> Any:
    """Return the value of a name that a notebook cell defines.

    :raises Missing: when no cell defines it.
    """
    if name not in run.names:
        raise Missing(name, name=name, among=run.names, try_=f'run the cell that defines {name}')
    return run.names[name]


def call(name: str, function: Any, *given: Any, wanted: Any = _ANY) -> Any:
    """Call a function or a class of the student, and return the result.

    :raises Failure: when it cannot be called, or raises an exception.
    :raises Mismatch: when it returns another value than `wanted`.
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
