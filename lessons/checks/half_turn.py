"""Half a turn, as a quaternion."""

from __future__ import annotations

from edugrade import Evidence, Mismatch, Rubric, check
from edugrade.library.called import defined


@check(points=1)
def it_is_half_a_turn(run: Evidence) -> None:
    """z and w describe half a turn"""
    seen = defined(run, 'z'), defined(run, 'w')
    numbers = all(isinstance(value, (int, float)) for value in seen)
    if not (numbers and abs(abs(seen[0]) - 1) < 1e-3 and abs(seen[1]) < 1e-3):
        raise Mismatch(
            'the rotation',
            'sin and cos of half of pi',
            f'z = {seen[0]!r}, w = {seen[1]!r}',
            try_='use the formula of section 8.1, with yaw = pi',
        )


RUBRIC = Rubric(title='Half a turn', names=['z', 'w'], checks=[it_is_half_a_turn])
