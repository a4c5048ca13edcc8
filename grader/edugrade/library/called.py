"""What a cell of a notebook has defined, called: whatever it raises is the student's to read, in a sentence."""

from __future__ import annotations

from typing import Any

from ..evidence import Evidence, Failure, Mismatch, Missing

_ANY = object()


def defined(run: Evidence, name: str) -> Any:
    """What a cell has defined under this name.

    :raises Missing: when no cell has.
    """
    if name not in run.names:
        raise Missing(name, name=name, among=run.names, try_=f'run the cell that defines {name}')
    return run.names[name]


def call(name: str, function: Any, *given: Any, wanted: Any = _ANY) -> Any:
    """What a function or a class of the student's returns.

    :raises Failure: when it cannot be called, or raises anything.
    :raises Mismatch: when `wanted` is given, and it returns something else.
    """
    words = f'{name}({", ".join(getattr(value, "__name__", None) or repr(value) for value in given)})'
    if not callable(function):
        raise Failure(f'{words} cannot be called', seen=f'{name} is {function!r}', try_=f'define {name}: with def, or with class')
    try:
        found = function(*given)
    except Exception as error:  # the student's own code may raise anything
        raise Failure(
            f'{words} raises {type(error).__name__}', seen=str(error) or 'no words', try_='call it in a cell of your own'
        ) from None
    if wanted is not _ANY and found != wanted:
        raise Mismatch(f'what {words} returns', repr(wanted), repr(found)[:500], try_='call it in a cell of your own')
    return found
