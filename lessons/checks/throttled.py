"""The check of lesson 11: a watcher that logs every two seconds, and not ten times a second."""

from __future__ import annotations

from edugrade import Evidence, Mismatch, Rubric, Scenario, check


@check(points=1)
def it_is_said_every_two_seconds(run: Evidence) -> None:
    """The node logs a missing frame every two seconds"""
    told = [log.time_s for log in run.first.logs if 'Could not transform' in log.message and 'nobody' in log.message]
    if not 3 <= len(told) <= 4:
        raise Mismatch(
            'the number of log lines in 7 s',
            '3 or 4',
            f'{len(told)}',
            where=run.source.place_in('watching.py', r'\.info\('),
            try_=['add an argument to info', 'throttle_duration_sec is in seconds, as a floating-point number'],
        )


RUBRIC = Rubric(
    title='Not ten times a second',
    decoys=1.0,  # the student's own program may log the same lines in any way
    of='my_ws/src/learning_tf2_py/launch/turtle_tf2_demo.launch.py',
    scenarios=lambda random: [Scenario('run', {'target_frame': 'nobody'}, 7.5)],
    checks=[it_is_said_every_two_seconds],
)
