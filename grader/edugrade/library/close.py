"""Numbers that must be near others: with a tolerance, and part of the points for what is nearly right."""

from __future__ import annotations

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
    try_: str | None = None,
) -> None:
    """A number is what it should be, give or take a tolerance; what is no number is not.

    :param near: a wider tolerance; within it the check fails and gives `share` of its points. 0: there is none.
    :raises Mismatch: with both numbers and how far they may be apart.
    """
    off = abs(seen - wanted)
    if off <= tolerance:
        return
    raise Mismatch(
        f'{thing}, when launched with {run.scenario(scenario).words},',
        f'{wanted:g}, give or take {tolerance:g}',
        f'{seen:g}',
        where=where or run.source.place,
        try_=try_,
        share=share if off <= near else 0.0,
    )
