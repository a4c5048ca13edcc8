"""The check of lesson 15: how far did the turtle of the bag drive?"""

from __future__ import annotations

from math import hypot

from edugrade import Evidence, Failure, Mismatch, Rubric, Scenario, check


@check(points=1)
def the_way_is_right(run: Evidence) -> None:
    """way logs how far the turtle drove"""
    said = [log.message for log in run.first.logs if log.logger == 'way']
    poses = [pose for _, pose in run.first.messages('/turtle1/pose')] if '/turtle1/pose' in run.first.topics else []
    wanted = sum(
        hypot(new.x - old.x, new.y - old.y) for old, new in zip(poses, poses[1:], strict=False)
    )  # a bag speaks here, no turtlesim
    try:
        seen = float(said[-1])
    except (IndexError, ValueError):
        raise Failure(
            'way logs no number', seen='\n'.join(said[-3:]) or 'no line', try_='run the cells of way.py again'
        ) from None
    if not abs(seen - wanted) < 0.4:
        raise Mismatch(
            'the distance in m',
            f'{wanted:.2f}',
            f'{seen:.2f}',
            where=run.source.place_in('way.py', 'way'),
            try_='add hypot(dx, dy) of this pose and the last one',
        )


RUBRIC = Rubric(
    title='The distance that the turtle drove',
    of='my_launch/way.launch.py',
    beside=['my_launch/way.py'],
    scenarios=lambda random: [Scenario('run', {}, 20.0)],
    checks=[the_way_is_right],
)
