"""Callbacks that wait for what only a later callback brings."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.runs import fact_place, node_of

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

LESSON = '13_large_project'
WAITS = {'call': 'call()', 'look': 'while not future.done()', 'await': 'await'}


def _of(recording: Recording, kind: str, *rest: str, but: frozenset[str] = frozenset()) -> Iterator[Finding]:
    """One finding for each fact of a kind; `rest` are the facts of its data that the sentences name.

    :param but: kinds of facts that explain one of this kind in the same program.
    """
    explained = {fact.process for fact in recording.facts if fact.kind in but}
    for fact in recording.facts:
        if fact.kind == kind and fact.process not in explained:
            file, line = fact_place(recording, fact)
            facts: dict[str, Any] = {name: fact.process if name == 'process' else fact.data.get(name) for name in rest}
            facts['callback'] = fact.data.get('callback') or fact.data.get('function') or 'lambda'
            facts['awaited'] = fact.data.get('name')
            node = fact.data.get('node') or node_of(recording, fact.process)
            yield found('node', node, file=file, line=line, time_s=fact.time_s, **facts)


@rule(
    'programs.deadlock',
    what='{callback}() of {node} waits for the answer of {awaited} with {waiting}, for ever',
    why='the answer can only be taken when {callback}() has ended: the node runs one callback at a time',
    do=(
        'go on when the answer comes: future.add_done_callback(self.answered); or give the client a callback group of its own '
        'and spin with a MultiThreadedExecutor'
    ),
    lesson=LESSON,
    level='error',
    hides=('messages.reply-not-taken', 'messages.not-taken', 'time.slow-callback', 'turtlesim.slow-commands'),
)
def deadlock(recording: Recording) -> Iterator[Finding]:
    """By call(), by a loop around future.done(), by spinning until a future is done, or by await in the same group."""
    for finding in _of(recording, 'callback waits', 'waiting'):
        waiting = finding.facts['waiting']
        yield finding._replace(facts={**finding.facts, 'waiting': WAITS.get(waiting, f'{waiting}()')})


@rule(
    'programs.callback-goes-on',
    what=(
        '{callback}() of {node} does not end, and the timer of {timers}() waits for it: it stands at {calls}()',
        '{callback}() of {node} does not end, and messages wait for it: it stands at {calls}()',
        '{callback}() of {node} does not end, and the other callbacks wait for it',
    ),
    why='a node runs one callback at a time; what this one waits for may be what it keeps from coming',
    do='return from {callback}() and go on in the next callback; keep in an attribute of the node how far you are',
    lesson=LESSON,
    level='error',
    hides=('time.sleep-in-callback', 'messages.not-taken', 'time.slow-callback'),
)
def goes_on(recording: Recording) -> Iterator[Finding]:
    """At the end of the run a callback is not over, for half a second at least, and others of its node are due."""
    for finding in _of(recording, 'callback goes on', 'timers', 'calls', but=EXPLAINED):
        calls = (finding.facts['calls'] or '').rpartition('.')[2] or None
        yield finding._replace(facts={**finding.facts, 'calls': calls})


EXPLAINED = frozenset(
    ('callback waits', 'spin in callback', 'spin in callback in vain', 'rate in callback', 'node not spun', 'waits for input')
)
"""Facts that say why a callback does not end."""


@rule(
    'programs.spin-in-callback',
    what='{callback}() of {node} spins its own node with {spins}(): until it ends, no other callback of its group runs',
    why='a callback is called by a spin already; what waits for it waits on',
    do='return from {callback}() and let the next message or timer go on: future.add_done_callback(...), or async and await',
    lesson=LESSON,
    hides=('messages.not-taken', 'time.slow-callback'),
)
def spin_in_callback(recording: Recording) -> Iterator[Finding]:
    """Inside the spin that called it."""
    yield from _of(recording, 'spin in callback', 'spins')
    yield from _of(recording, 'spin in callback in vain', 'spins')


@rule(
    'programs.node-taken-away',
    what='{callback}() of {node} spins its node with {spins}(), which takes it away from the executor that called it',
    why='that executor does not come back to the node: after this callback nothing of it is called any more',
    do='take {spins}() out of {callback}(); use future.add_done_callback(...), or async and await',
    lesson=LESSON,
    level='error',
)
def node_taken_away(recording: Recording) -> Iterator[Finding]:
    """The node was in an executor of the student's, and rclpy.spin... moves it into the global one."""
    return _of(recording, 'node taken away', 'spins')


@rule(
    'programs.other-node-spun',
    what='{node} is spun until the answer of {awaited} comes, but the client that waits for it is of {other}',
    why='an answer is taken by the node that asked, and nobody spins that one',
    do='spin {other}, or make the client in {node}',
    lesson=LESSON,
    level='error',
    hides=('messages.reply-not-taken', 'programs.never-spun'),
)
def other_node_spun(recording: Recording) -> Iterator[Finding]:
    """`spin_until_future_complete` with the future of another node's client."""
    return _of(recording, 'other node spun', 'other')


@rule(
    'time.rate-in-callback',
    what='{callback}() of {node} waits for ever at rate.sleep()',
    why='a rate is woken by a timer of the node, and the node is busy with {callback}()',
    do='take the loop out and let a timer call you: self.create_timer(0.1, self.step)',
    lesson='09_broadcaster_and_listener',
    level='error',
    hides=('messages.not-taken', 'time.slow-callback', 'turtlesim.slow-commands'),
)
def rate_in_callback(recording: Recording) -> Iterator[Finding]:
    """The executor that would call the timer of the rate waits for the callback."""
    return _of(recording, 'rate in callback')


@rule(
    'time.rate-not-spun',
    what='{function}() of {node} waits for ever at rate.sleep()',
    why='a rate is woken by a timer of the node, and nobody spins the node yet',
    do='take the loop out of {function}() and let a timer call you: self.create_timer(0.1, self.step)',
    lesson='09_broadcaster_and_listener',
    level='error',
    hides=('programs.never-spun', 'turtlesim.slow-commands'),
)
def rate_not_spun(recording: Recording) -> Iterator[Finding]:
    """A program that stands at rate.sleep() while its node is in no executor, in a constructor for instance."""
    for finding in _of(recording, 'node not spun', 'calls', 'function'):
        if finding.facts['calls'] == 'timer.sleep':
            yield finding


@rule(
    'programs.callback-missing',
    what='{function}() of {node} is given None in place of a function',
    why='with brackets the function runs once, now, and what it returns is handed over: None',
    do='give the function itself, without brackets: self.tick, not self.tick()',
    lesson='09_broadcaster_and_listener',
    level='error',
    hides=('programs.died', 'turtlesim.slow-commands'),
)
def callback_missing(recording: Recording) -> Iterator[Finding]:
    """A timer or service."""
    return _of(recording, 'callback missing', 'function', 'process')


@rule(
    'programs.transition-failed',
    what=('{callback}() of {node} raised {raised}', '{callback}() of {node} returned {returned}, no TransitionCallbackReturn'),
    why='rclpy takes that for an error of the transition, and says nothing: the node goes back or ends',
    do='return TransitionCallbackReturn.SUCCESS at the end of {callback}()',
    lesson=LESSON,
    level='error',
    hides=('programs.not-activated',),
)
def transition_failed(recording: Recording) -> Iterator[Finding]:
    """A callback of a lifecycle node."""
    return _of(recording, 'transition failed', 'raised', 'returned')


@rule(
    'programs.waits-for-input',
    what='{process} waits for input that never comes',
    why='a program of a launch file has no keyboard',
    do='start it with "ros2 run" in a terminal of its own; or give it its text: edulaunch launch ... --stdin, Session(stdin=...)',
    lesson=LESSON,
    level='error',
)
def waits_for_input(recording: Recording) -> Iterator[Finding]:
    """It read its keyboard without a time limit."""
    for fact in recording.facts:
        if fact.kind == 'waits for input' and fact.process is not None:
            file, line = fact_place(recording, fact)
            yield found('process', fact.process, file=file, line=line, time_s=fact.time_s)
