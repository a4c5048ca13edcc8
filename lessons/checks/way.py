"""The check of lesson 15: how far did the turtle of the bag drive?"""

from __future__ import annotations

from math import hypot

from edugrade import Evidence, Failure, Mismatch, Rubric, Scenario, check


@check(points=1)
def the_way_is_right(run: Evidence) -> None:
    """way logs how far the turtle drove"""
    said = [log for log in run.first.logs if log.logger == 'way']
    poses = run.first.messages('/turtle1/pose') if '/turtle1/pose' in run.first.topics else []
    if not said:
        raise Failure('way logs no number', seen='no line', try_='run the cells of way.py again')
    for log in reversed(said):
        past = [pose for time_s, pose in poses if time_s <= log.time_s]  # a bag speaks here, no turtlesim
        wanted = sum(hypot(new.x - old.x, new.y - old.y) for old, new in zip(past, past[1:], strict=False))
        try:
            seen = float(log.message)
        except ValueError:
            raise Failure('way logs no number', seen=log.message, try_='run the cells of way.py again') from None
        if not abs(seen - wanted) < 0.4:
            raise Mismatch(
                f'the distance in m at {log.time_s:.2f} s',
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
