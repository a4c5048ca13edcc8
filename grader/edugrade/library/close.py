"""Compares numbers with a tolerance, and gives a share of the points for a number that is nearly right."""

from __future__ import annotations

from ..evidence import Advice, Evidence, Mismatch


def require_close(
    run: Evidence,
    scenario: str,
    thing: str,
    seen: float,
    wanted: float,
    tolerance: float,
    near: float = 0.0,
    share: float = 0.5,
    *,
    where: tuple[str, int | None] | None = None,
    try_: Advice = None,
    beside: str = '',
    unit: str = '',
) -> None:
    """Require a number within a tolerance. NaN never passes.

    :param near: a wider tolerance, or 0. Within it, the check fails but gives `share` of its points.
    :param beside: a remark about the number that was found, which the report shows after the number.
    :param unit: the unit of both numbers, such as 's'.
    :raises Mismatch: with both numbers and the tolerance, if the number is outside the tolerance.
    """
    off = abs(seen - wanted)
    if off <= tolerance:
        return
    raise Mismatch(
        thing,
        f'{wanted:g} ± {tolerance:g} {unit}'.rstrip(),
        f'{seen:g} {unit}'.rstrip() + (beside and f', {beside}'),
        during=run.scenario(scenario).words,
        where=where or run.source.place,
        try_=try_,
        share=share if off <= near else 0.0,
    )
