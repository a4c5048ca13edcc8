"""The ways a check says no.

::

    Failure           what is wrong, and what would put it right
    ├── Missing       something that should be there is not; names the nearest thing that is
    └── Mismatch      something is there, but is not what was asked for
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from .place import Place


class Failure(Exception):
    """Raised by a check: the submission does not do what the check's sentence says.

    :param rationale: one sentence that says what is wrong, naming the thing.
    :param expected: what was looked for, in words or as a value.
    :param seen: what was there instead.
    :param where: (file, line) of the launch action or the file to change.
    :param try_: the first thing to try; or several texts, of which a student sees the next one after some tries.
    :param share: of the points, that are given all the same: from 0 up to, not including, 1.
    """

    def __init__(
        self,
        rationale: str,
        *,
        expected: object = None,
        seen: object = None,
        where: tuple[str, int | None] | None = None,
        try_: str | Sequence[str] | None = None,
        share: float = 0.0,
    ) -> None:
        super().__init__(rationale)
        self.rationale = rationale
        self.expected = None if expected is None else str(expected)
        self.seen = None if seen is None else str(seen)
        self.where = None if where is None else Place(*where)
        texts = [try_] if isinstance(try_, str) else list(try_ or ())
        self.steps, self.try_ = tuple(texts[:-1]), texts[-1] if texts else None
        self.share = share if 0.0 <= share < 1.0 else 0.0


class Missing(Failure):
    """Something is absent.

    :param thing: what is absent, with its name, such as ``the launch argument "circle_radius"``.
    :param name: the bare name that was looked for; with `among`, the nearest name is offered in the report.
    :param among: the names that are there.
    """

    def __init__(
        self,
        thing: str,
        *,
        name: str | None = None,
        among: Iterable[str] = (),
        expected: object = None,
        seen: object = None,
        where: tuple[str, int | None] | None = None,
        try_: str | Sequence[str] | None = None,
    ) -> None:
        known = list(among)
        if seen is None:
            seen = ', '.join(known) if known else 'nothing of the kind'
        super().__init__(
            f'{thing} is missing', expected=expected or name, seen=seen, where=where, try_=_with_nearest(try_, name, known)
        )


class Mismatch(Failure):
    """Something is there with another value; both values are shown in full, never shortened."""

    def __init__(
        self,
        thing: str,
        expected: object,
        seen: object,
        *,
        where: tuple[str, int | None] | None = None,
        try_: str | Sequence[str] | None = None,
        share: float = 0.0,
    ) -> None:
        words = f'{thing} is not what was asked for'
        super().__init__(words, expected=expected, seen=seen, where=where, try_=try_, share=share)


def _with_nearest(try_: str | Sequence[str] | None, name: str | None, known: list[str]) -> str | Sequence[str] | None:
    if name is None or name in known or not (try_ is None or isinstance(try_, str)):
        return try_
    from edulaunch.nearest import nearest

    close = nearest(name, known)
    if close is None:
        return try_
    question = f'did you mean "{name}" where you wrote "{close}"?'
    return question if try_ is None else f'{question} Otherwise: {try_}'
