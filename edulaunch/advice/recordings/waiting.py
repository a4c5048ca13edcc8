"""Time that programs take from themselves."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule
from edulaunch.advice.runs import fact_place, node_of, node_place

if TYPE_CHECKING:
    from edulaunch.recording import Recording
    from edulaunch.recording.records import Fact

LESSON = '09_broadcaster_and_listener'
OFTEN = 3
"""Fewer late calls than that are no pattern: nodes come late to their first ones."""


def _of(recording: Recording, kind: str) -> list[Fact]:
    return [fact for fact in recording.facts if fact.kind == kind]


def _late(recording: Recording) -> list[Fact]:
    """Timers of which calls were left out again and again, and topics that wait."""
    skipped = [fact for fact in _of(recording, 'timer skipped') if fact.times >= OFTEN]
    return [*skipped, *_of(recording, 'messages wait')]


@rule(
    'time.sleep-in-callback',
    what=(
        '{callback}() of {node} sleeps ({seconds} s, {times} times), and the timer of {timers}() has to wait meanwhile',
        '{callback}() of {node} sleeps ({seconds} s, {times} times), and {topics} has to wait meanwhile',
    ),
    why='a node runs one callback at a time: while one sleeps, no other timer and no message is served',
    do='take the sleep out and let a timer call you: self.create_timer({seconds}, self.next_step)',
    lesson=LESSON,
    hides=('time.slow-callback', 'messages.not-taken'),
)
def sleep_in_callback(recording: Recording) -> Iterator[Finding]:
    """Only where something else of the same program came late by it; once of each callback."""
    told: set[tuple[str | None, str | None]] = set()
    for fact in _of(recording, 'sleep in callback'):
        late = [one for one in _late(recording) if one.process == fact.process]
        callback = fact.data['callback'] or fact.data.get('function')
        if late and (fact.process, callback) not in told:
            told.add((fact.process, callback))
            file, line = fact_place(recording, fact)
            timers = dict.fromkeys(one.data['callback'] or 'timer' for one in late if 'callback' in one.data)
            topics = dict.fromkeys(one.data['topic'] for one in late if 'topic' in one.data)
            facts = {'callback': callback, 'seconds': fact.data['seconds'], 'times': fact.times}
            node = fact.data['node'] or node_of(recording, fact.process)
            yield found('node', node, file=file, line=line, time_s=fact.time_s, timers=list(timers), topics=list(topics), **facts)


@rule(
    'time.slow-callback',
    what='the timer of {callback}() in {node} is to call every {period_s} s, but comes up to {late_s} s late ({times} times)',
    why='calls that are missed are left out; the node is busy with something that takes longer than the period',
    do='give the timer a longer period, or make the callbacks of {node} shorter',
    lesson=LESSON,
)
def slow_callback(recording: Recording) -> Iterator[Finding]:
    """Whole periods were missed, three times at least."""
    for fact in _of(recording, 'timer skipped'):
        if fact.times >= OFTEN:
            file, line = node_place(recording, fact.data['node'] or '')
            facts = {
                'callback': fact.data['callback'] or 'timer',
                'period_s': fact.data['period_s'],
                'late_s': fact.data['late_s'],
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


@rule(
    'time.timer-period',
    what='the timer of {callback}() in {node} has a period of {period_s} s: is that what you mean?',
    why='create_timer() takes seconds: 0.5 is twice a second',
    do='give the seconds between two calls, such as create_timer(0.1, ...) for ten times a second',
    lesson=LESSON,
    confidence='asked',
)
def timer_period(recording: Recording) -> Iterator[Finding]:
    """No period at all, or one longer than 45 s."""
    for fact in _of(recording, 'timer period'):
        file, line = fact_place(recording, fact)
        period_s = fact.data['period_s']
        facts = {'callback': fact.data['callback'] or 'timer', 'period_s': period_s}
        yield found('node', fact.data['node'], file=file, line=line, time_s=fact.time_s, **facts)


@rule(
    'time.no-clock',
    what='{node} goes by the simulated clock (use_sim_time is true), but nobody publishes /clock',
    why='its time stands still at 0: timers never call, and stamps are 0',
    do='set use_sim_time to false, or start the simulator that publishes /clock',
    lesson='13_large_project',
    level='error',
    hides=('tf.unstamped',),
)
def no_clock(recording: Recording) -> Iterator[Finding]:
    """Not a single message of /clock in the whole run."""
    clock = recording.topics.get('/clock')
    if clock is not None and clock.count:
        return
    for node in recording.nodes:
        parameter = recording.parameters(node.name).get('use_sim_time')
        if parameter is not None and parameter.value is True:
            file, line = node_place(recording, node.name)
            yield found('node', node.name, file=file, line=line, time_s=node.started_s)
