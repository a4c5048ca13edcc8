"""Compares numbers with a tolerance, and gives a share of the points for a number that is nearly right."""

from __future__ import annotations

from collections.abc import Sequence

from ..evidence import Evidence, Mismatch


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
    try_: str | Sequence[str] | None = None,
    beside: str = '',
) -> None:
    """Require a number within a tolerance. NaN never passes.

    :param near: a wider tolerance, or 0. Within it, the check fails but gives `share` of its points.
    :param beside: a remark about the number that was found, which the report shows after the number.
    :raises Mismatch: with both numbers and the tolerance, if the number is outside the tolerance.
    """
    off = abs(seen - wanted)
    if off <= tolerance:
        return
    raise Mismatch(
        f'{thing} in the run with {run.scenario(scenario).words}',
        f'{wanted:g} ± {tolerance:g}',
        f'{seen:g}, {beside}' if beside else f'{seen:g}',
        where=where or run.source.place,
        try_=try_,
        share=share if off <= near else 0.0,
    )
