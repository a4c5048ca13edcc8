"""How programs and nodes come to life, and end."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule
from edulaunch.advice.runs import ends_by_name, node_place, places

if TYPE_CHECKING:
    from edulaunch.recording import Recording

LESSON = '13_large_project'
CHANGE = 'lifecycle_msgs/srv/ChangeState'


@rule(
    'programs.not-configured',
    what='{node} is a lifecycle node, and nobody configures it: it stays unconfigured and does nothing',
    why='a lifecycle node makes its publishers and timers when it is told to: first configure, then activate',
    do=(
        'send both transitions: ros2 lifecycle set {node} configure, then activate; or emit ChangeState events in the launch file'
    ),
    lesson=LESSON,
    level='error',
)
def not_configured(recording: Recording) -> Iterator[Finding]:
    """Without a single transition in the whole run."""
    for node, states in _lifecycles(recording):
        if not states:
            file, line = node_place(recording, node)
            yield found('node', node, file=file, line=line)


@rule(
    'programs.not-activated',
    what='{node} is configured, but never activated: it is {state} at the end',
    why='a lifecycle publisher sends nothing before its node is active',
    do='activate it: ros2 lifecycle set {node} activate; or emit a second ChangeState event when it has become inactive',
    lesson=LESSON,
    level='error',
)
def not_activated(recording: Recording) -> Iterator[Finding]:
    """It was configured once and never reached 'active', and no node is there that leads it through its states."""
    for node, states in _lifecycles(recording):
        if states and 'active' not in states and states[-1] == 'inactive' and not _is_led(recording, node):
            file, line = node_place(recording, node)
            yield found('node', node, file=file, line=line, state=states[-1])


def _is_led(recording: Recording, node: str) -> bool:
    alive = {one.name for one in recording.nodes if one.ended_s is None and not one.name.startswith('/launch_ros')}
    return any(end.node in alive for end in ends_by_name(recording).get(('client', f'{node}/change_state'), ()))


def _lifecycles(recording: Recording) -> Iterator[tuple[str, list[str]]]:
    """Lifecycle nodes with the states that they reached, in order."""
    for (kind, name), ends in ends_by_name(recording).items():
        if kind == 'service' and ends[0].type == CHANGE and name.endswith('/change_state'):
            node = name.removesuffix('/change_state')
            topic = f'{node}/transition_event'
            told = recording.messages(topic) if topic in recording.topics else []
            yield node, [message.goal_state.label for _, message in told]


@rule(
    'programs.ended-by-force',
    what=(
        'Ctrl-C did not end {process}: it still waited at {calls}() in {function}(), and was killed 5 s later',
        'Ctrl-C did not end {process}, and it was killed 5 s later',
    ),
    why='a thread that waits for ever, or a caught KeyboardInterrupt, keeps the program alive',
    do='let the thread end when rclpy.ok() is false, or make it a daemon: Thread(target=..., daemon=True)',
    lesson=LESSON,
    hides=('programs.died',),
)
def ended_by_force(recording: Recording) -> Iterator[Finding]:
    """launch had to send SIGTERM or SIGKILL, as it says itself."""
    refused = {word for row in recording._content['output'] if 'failed to terminate' in row[3] for word in _named(row[3])}
    for fact in recording.facts:
        if fact.kind == 'ended by force' and fact.process in refused:
            waits = [wait for wait in fact.data['waits'] if 'file' in wait]
            place = (waits[-1]['file'], waits[-1]['line']) if waits else places(recording).get(fact.process, (None, None))
            facts = {'calls': waits[-1]['calls'].partition('.')[2], 'function': waits[-1]['function']} if waits else {}
            yield found('process', fact.process, file=place[0], line=place[1], time_s=fact.time_s, **facts)


def _named(text: str) -> Iterator[str]:
    """The program that a line of launch is about: '[ERROR] [listener-2]: process[listener-2] failed to terminate ...'."""
    for line in text.splitlines():
        before, found_it, _ = line.partition('] failed to terminate')
        if found_it:
            yield before.rpartition('[')[2]
