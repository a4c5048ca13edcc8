"""Rules about slow callbacks and timers, and about the start and the end of programs and nodes."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import script_of, walked
from edulaunch.advice.runs import ends_by_name, fact_place, files_of, node_of, node_place, places

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import Fact

LESSON = '09_broadcaster_and_listener'
_IDLE = re.compile(r'\b(True|1|ok|time|now|monotonic)\b')
"""Matches the condition of a `while` loop that only lets time pass."""
OFTEN = 3
"""With at least this many late calls, they form a pattern. The first calls of nodes are often late."""


def _of(recording: Recording, kind: str) -> list[Fact]:
    return [fact for fact in recording.facts if fact.kind == kind]


def _late(recording: Recording) -> list[Fact]:
    """Return the facts about timers that skipped calls repeatedly, and about topics with waiting messages."""
    skipped = [fact for fact in _of(recording, 'timer skipped') if fact.times >= OFTEN]
    return [*skipped, *_of(recording, 'messages wait')]


@rule(
    'time.timers-pile-up',
    what='this line creates a new timer each time it runs, so {node} has {count} timers that all call {callback}()',
    why='a timer keeps running until it is cancelled, so {callback}() is called more and more often',
    do='create the timer once, in __init__, or cancel the old one first with self.timer.cancel()',
    lesson='09_broadcaster_and_listener',
    level='error',
    hides=('messages.not-taken', 'time.slow-callback'),
)
def timers_pile_up(recording: Recording) -> Iterator[Finding]:
    """Report a line that repeatedly creates timers for the same callback."""
    started = {node.name: node.started_s for node in recording.nodes}
    for fact in recording.facts:
        node = str(fact.data.get('node'))
        if fact.kind == 'timers pile up' and fact.time_s > started.get(node, 0.0):  # a constructor may create several
            file, line = fact_place(recording, fact)
            facts = {'callback': fact.data['callback'] or 'the function', 'count': fact.data['count']}
            yield found('node', node, file=file, line=line, time_s=fact.time_s, **facts)


@rule(
    'time.sleep-in-callback',
    what=(
        '{callback}() in {node} sleeps ({seconds} s, {times} times), so the timer of {timers}() has to wait',
        '{callback}() in {node} sleeps ({seconds} s, {times} times), so messages on {topics} have to wait',
    ),
    why='a node runs one callback at a time, so no timer or message is handled during a sleep',
    do='replace the sleep with a timer: self.create_timer({seconds}, self.next_step)',
    lesson=LESSON,
    hides=('time.slow-callback', 'messages.not-taken'),
)
def sleep_in_callback(recording: Recording) -> Iterator[Finding]:
    """Report each callback once if it sleeps and so delays a timer or a message of its program."""
    reported: set[tuple[str | None, str | None]] = set()
    for fact in _of(recording, 'sleep in callback'):
        late = [one for one in _late(recording) if one.process == fact.process]
        callback = fact.data['callback'] or fact.data.get('function')
        if late and (fact.process, callback) not in reported:
            reported.add((fact.process, callback))
            file, line = fact_place(recording, fact)
            timers = dict.fromkeys(one.data['callback'] or 'timer' for one in late if 'callback' in one.data)
            topics = dict.fromkeys(one.data['topic'] for one in late if 'topic' in one.data)
            facts = {'callback': callback, 'seconds': fact.data['seconds'], 'times': fact.times}
            node = fact.data['node'] or node_of(recording, fact.process)
            yield found('node', node, file=file, line=line, time_s=fact.time_s, timers=list(timers), topics=list(topics), **facts)


@rule(
    'time.slow-callback',
    what='the timer of {callback}() in {node} has a period of {period_s} s, but is up to {late_s} s late ({times} times)',
    why='the node is busy for longer than the period, and rclpy skips the calls that it misses',
    do=(
        'remove the loop on line {loop}: the timer calls {callback}() again',
        'use a longer period for the timer, or make the callbacks of {node} shorter',
    ),
    lesson=LESSON,
)
def slow_callback(recording: Recording) -> Iterator[Finding]:
    """Report a callback that made a timer miss at least three whole periods."""
    for fact in _of(recording, 'timer skipped'):
        if fact.times >= OFTEN:
            file, line, loop = _callback_place(recording, fact.data['node'] or '', fact.data['callback'])
            facts = {
                'callback': fact.data['callback'] or 'timer',
                'period_s': fact.data['period_s'],
                'late_s': fact.data['late_s'],
                'loop': loop,
            }
            yield found(
                'node',
                fact.data['node'] or node_of(recording, fact.process),
                file=file,
                line=line,
                time_s=fact.time_s,
                times=fact.times,
                **facts,
            )


def _callback_place(recording: Recording, node: str, callback: str | None) -> tuple[str | None, int | None, int | None]:
    """Return the file and line of a callback and the line of its `while` loop, or the place at which its program was started."""
    for file in sorted(files_of(recording, node)):
        for function in walked(tree) if (tree := script_of(file)) is not None else ():
            if isinstance(function, ast.FunctionDef) and function.name == callback:
                loops = [
                    inner.lineno
                    for inner in ast.walk(function)
                    if isinstance(inner, ast.While) and _IDLE.search(ast.unparse(inner.test))
                ]
                return file, function.lineno, loops[0] if loops else None
    return (*node_place(recording, node), None)


@rule(
    'time.timer-period',
    what='the timer of {callback}() in {node} has an unusual period: {period_s} s',
    why='create_timer() expects seconds: 0.5 means twice a second',
    do='if you want another period, write the seconds between two calls, such as create_timer(0.1, ...) for ten calls a second',
    lesson=LESSON,
    confidence='asked',
)
def timer_period(recording: Recording) -> Iterator[Finding]:
    """Report a timer with a period of 0, or longer than 45 s."""
    for fact in _of(recording, 'timer period'):
        file, line = fact_place(recording, fact)
        period_s = fact.data['period_s']
        facts = {'callback': fact.data['callback'] or 'timer', 'period_s': period_s}
        yield found('node', fact.data['node'], file=file, line=line, time_s=fact.time_s, **facts)


@rule(
    'time.no-clock',
    what='{node} uses simulated time (use_sim_time is true), but no node publishes on /clock',
    why='the clock of the node stays at 0, so its timers never run, and all its time stamps are 0',
    do='set use_sim_time to false, or start the simulator that publishes on /clock',
    lesson='13_large_project',
    level='error',
    hides=('tf.unstamped',),
)
def no_clock(recording: Recording) -> Iterator[Finding]:
    """Report a node with use_sim_time in a run without a message on /clock."""
    clock = recording.topics.get('/clock')
    if clock is not None and clock.count:
        return
    for node in recording.nodes:
        parameter = recording.parameters(node.name).get('use_sim_time')
        if parameter is not None and parameter.value is True:
            file, line = node_place(recording, node.name)
            yield found('node', node.name, file=file, line=line, time_s=node.started_s)


LARGE_PROJECT = '13_large_project'
CHANGE = 'lifecycle_msgs/srv/ChangeState'


@rule(
    'programs.not-configured',
    what='the lifecycle node {node} is never configured, so it remains unconfigured and does nothing',
    why='a lifecycle node creates its publishers and timers when it is configured, and uses them when it is active',
    do=(
        'run `ros2 lifecycle set {node} configure` and then the same with `activate`, or emit ChangeState events '
        'in the launch file'
    ),
    lesson=LARGE_PROJECT,
    level='error',
    hides=('messages.nobody-publishes', 'messages.no-server'),
)
def not_configured(recording: Recording) -> Iterator[Finding]:
    """Report a lifecycle node that made no transition during the whole run."""
    for node, states in _lifecycles(recording):
        if not states:
            file, line = node_place(recording, node)
            yield found('node', node, file=file, line=line)


@rule(
    'programs.not-activated',
    what='{node} is configured but never activated; its final state is {state}',
    why='a lifecycle publisher sends nothing until its node is active',
    do='run `ros2 lifecycle set {node} activate`, or emit a second ChangeState event when the node has become inactive',
    lesson=LARGE_PROJECT,
    level='error',
)
def not_activated(recording: Recording) -> Iterator[Finding]:
    """Report a lifecycle node that is configured and never became active, if no other node manages its states."""
    for node, states in _lifecycles(recording):
        if states and 'active' not in states and states[-1] == 'inactive' and not _is_led(recording, node):
            file, line = node_place(recording, node)
            yield found('node', node, file=file, line=line, state=states[-1])


def _is_led(recording: Recording, node: str) -> bool:
    alive = {one.name for one in recording.nodes if one.ended_s is None and not one.name.startswith('/launch_ros')}
    return any(end.node in alive for end in ends_by_name(recording).get(('client', f'{node}/change_state'), ()))


def _lifecycles(recording: Recording) -> Iterator[tuple[str, list[str]]]:
    """Yield each lifecycle node with the states that it reached, in order."""
    for (kind, name), ends in ends_by_name(recording).items():
        if kind == 'service' and ends[0].type == CHANGE and name.endswith('/change_state'):
            node = name.removesuffix('/change_state')
            topic = f'{node}/transition_event'
            reported = recording.messages(topic) if topic in recording.topics else []
            yield node, [message.goal_state.label for _, message in reported]


@rule(
    'programs.ended-by-force',
    what=(
        '{process} ignored Ctrl-C while {function}() waited in {calls}(), and launch killed it 5 s later',
        '{process} ignored Ctrl-C, and launch killed it 5 s later',
    ),
    why='a thread that waits forever, or code that catches KeyboardInterrupt, prevents the program from ending',
    do='end the thread when rclpy.ok() is false, or make it a daemon: Thread(target=..., daemon=True)',
    lesson=LARGE_PROJECT,
    hides=('programs.died',),
)
def ended_by_force(recording: Recording) -> Iterator[Finding]:
    """Report a program to which launch had to send SIGTERM or SIGKILL, if launch has logged that."""
    refused = {word for row in recording.rows('output') if 'failed to terminate' in row[3] for word in _named(row[3])}
    for fact in recording.facts:
        if fact.kind == 'ended by force' and fact.process in refused:
            waits = [wait for wait in fact.data['waits'] if 'file' in wait]
            place = (waits[-1]['file'], waits[-1]['line']) if waits else places(recording).get(fact.process, (None, None))
            facts = {'calls': waits[-1]['calls'].partition('.')[2], 'function': waits[-1]['function']} if waits else {}
            yield found('process', fact.process, file=place[0], line=place[1], time_s=fact.time_s, **facts)


def _named(text: str) -> Iterator[str]:
    """Yield the programs in lines of launch such as '[ERROR] [listener-2]: process[listener-2] failed to terminate ...'."""
    for line in text.splitlines():
        before, found_it, _ = line.partition('] failed to terminate')
        if found_it:
            yield before.rpartition('[')[2]
