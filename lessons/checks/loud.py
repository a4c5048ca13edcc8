"""The check of lesson 7, your turn: a parameter file in the package."""

from __future__ import annotations

from edugrade import Evidence, Mismatch, Rubric, Scenario, check
from edugrade.library.node_graph import require_topic


@check(points=1)
def hello_speaks(run: Evidence) -> None:
    """hello publishes on /greeting"""
    require_topic(run, 'run', '/greeting', 'std_msgs/msg/String', 'my_robot', 'start hello in loud.launch.py')


@check(points=1, needs=[hello_speaks])
def it_says_it_loud(run: Evidence) -> None:
    """hello publishes HELLO"""
    said = sorted({message.data for _, message in run.first.messages('/greeting')})
    if said != ['HELLO']:
        raise Mismatch(
            'the published word', 'HELLO', ', '.join(said), where=run.source.place, try_='check the word in config/loud.yaml'
        )


@check(points=1, needs=[hello_speaks])
def the_word_is_a_parameter(run: Evidence) -> None:
    """The word comes from a parameter file"""
    found = run.first.parameters('/hello').get('word')
    if found is None or found.value != 'HELLO' or '.yaml' not in found.origin:
        seen = 'no such parameter' if found is None else f'{found.value}, from {found.origin}'
        raise Mismatch(
            'the parameter word of /hello',
            'HELLO, from config/loud.yaml',
            seen,
            where=run.source.place,
            try_='declare it in hello.py, and write parameters=[the path of the file] in the Node',
        )


RUBRIC = Rubric(
    title='A loud package',
    decoys=0.7,  # the student's own program may publish the word in any way; the parameter is worth the rest
    of='my_ws/src/my_robot/launch/loud.launch.py',
    scenarios=lambda random: [Scenario('run', {}, 2.0)],
    checks=[hello_speaks, it_says_it_loud, the_word_is_a_parameter],
)
