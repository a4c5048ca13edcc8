"""Rules about callbacks that wait for a result that only a later callback can provide."""

from __future__ import annotations

import linecache
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.recordings.programs import terminal_windows
from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.runs import fact_place, node_of

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

LESSON = '13_large_project'
_SEND_GOAL = re.compile(r'([\w.]+)\.send_goal\(')
WAITS = {'call': 'call()', 'look': 'while not future.done()', 'await': 'await'}


def _of(recording: Recording, kind: str, *rest: str, but: frozenset[str] = frozenset()) -> Iterator[Finding]:
    """Yield one finding for each fact of a kind.

    :param kind: the kind of the fact.
    :param rest: the names of the other facts that the sentences contain.
    :param but: kinds of facts that already explain a fact of this kind in the same program.
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
    what='{callback}() in {node} blocks forever in {waiting}, waiting for a reply from {awaited}',
    why='the node runs one callback at a time, so it cannot receive the reply until {callback}() returns',
    do=(
        'write self.future = {client}.send_goal_async(goal), and then self.future.add_done_callback(self.accepted)',
        'call future.add_done_callback(self.answered), or create the client with its own callback group and spin with a '
        'MultiThreadedExecutor',
    ),
    lesson=LESSON,
    level='error',
    hides=('messages.reply-not-taken', 'messages.not-taken', 'time.slow-callback', 'turtlesim.slow-commands'),
)
def deadlock(recording: Recording) -> Iterator[Finding]:
    """Report a callback that waits for a reply which only the same executor or callback group could receive.

    The callback waits in call(), in a loop around future.done(), by spinning, or with await.
    """
    for finding in _of(recording, 'callback waits', 'waiting'):
        waiting = finding.facts['waiting']
        goal = _SEND_GOAL.search(linecache.getline(finding.file or '', finding.line or 0))
        facts = {'waiting': 'send_goal()' if goal else WAITS.get(waiting, f'{waiting}()'), 'client': goal and goal[1]}
        yield finding._replace(facts={**finding.facts, **facts})


@rule(
    'programs.callback-goes-on',
    what=(
        '{callback}() in {node} never returns from {calls}(), so the timer of {timers}() has to wait',
        '{callback}() in {node} never returns from {calls}(), so new messages have to wait',
        '{callback}() in {node} never returns, so the other callbacks have to wait',
    ),
    why='a node runs one callback at a time, so this callback may block the one that it waits for',
    do='return from {callback}() and continue in the next call; store the progress in an attribute of the node',
    lesson=LESSON,
    level='error',
    hides=('time.sleep-in-callback', 'messages.not-taken', 'time.slow-callback'),
)
def goes_on(recording: Recording) -> Iterator[Finding]:
    """Report a callback that still runs at the end, after at least half a second, while other callbacks of its node wait."""
    for finding in _of(recording, 'callback goes on', 'timers', 'calls', but=EXPLAINED):
        calls = (finding.facts['calls'] or '').rpartition('.')[2] or None
        calls = None if calls == '<lambda>' else calls
        yield finding._replace(facts={**finding.facts, 'calls': calls})


EXPLAINED = frozenset(
    ('callback waits', 'spin in callback', 'spin in callback in vain', 'rate in callback', 'node not spun', 'waits for input')
)
"""Facts that explain why a callback does not end."""


@rule(
    'programs.spin-in-callback',
    what='{callback}() in {node} calls {spins}() on its own node, which blocks the other callbacks of its group',
    why='the executor is already spinning the node when it calls a callback',
    do='return from {callback}(), and continue in future.add_done_callback(...), or use async and await',
    lesson=LESSON,
    hides=('messages.not-taken', 'time.slow-callback'),
)
def spin_in_callback(recording: Recording) -> Iterator[Finding]:
    """Report a callback that spins its own executor."""
    yield from _of(recording, 'spin in callback', 'spins')
    yield from _of(recording, 'spin in callback in vain', 'spins')


@rule(
    'programs.node-taken-away',
    what='{callback}() in {node} calls {spins}() on its own node, which removes the node from its executor',
    why='the executor does not add the node again, so it calls no further callback of this node',
    do='remove {spins}() from {callback}(), and use future.add_done_callback(...), or async and await',
    lesson=LESSON,
    level='error',
)
def node_taken_away(recording: Recording) -> Iterator[Finding]:
    """Report a node that a function such as rclpy.spin() moves from the student's executor to the global executor."""
    return _of(recording, 'node taken away', 'spins')


@rule(
    'programs.other-node-spun',
    what='{node} spins until {awaited} replies, but the client that sent the request belongs to {other}',
    why='only the node that sent the request receives the reply, and that node is not spinning',
    do='spin {other}, or create the client in {node}',
    lesson=LESSON,
    level='error',
    hides=('messages.reply-not-taken', 'programs.never-spun'),
)
def other_node_spun(recording: Recording) -> Iterator[Finding]:
    """Report a call such as `spin_until_future_complete` that waits for the future of another node's client."""
    return _of(recording, 'other node spun', 'other')


@rule(
    'time.rate-in-callback',
    what='{callback}() in {node} waits forever at rate.sleep()',
    why='a timer of the node ends rate.sleep(), and that timer cannot run before {callback}() returns',
    do='replace the loop with a timer: self.create_timer(0.1, self.step)',
    lesson='09_broadcaster_and_listener',
    level='error',
    hides=('messages.not-taken', 'time.slow-callback', 'turtlesim.slow-commands'),
)
def rate_in_callback(recording: Recording) -> Iterator[Finding]:
    """Report rate.sleep() in a callback. The executor cannot run the timer of the rate before the callback ends."""
    return _of(recording, 'rate in callback')


@rule(
    'time.rate-not-spun',
    what='{function}() in {node} waits forever at rate.sleep()',
    why='a timer of the node ends rate.sleep(), and that timer runs only while the node spins',
    do='replace the loop in {function}() with a timer: self.create_timer(0.1, self.step)',
    lesson='09_broadcaster_and_listener',
    level='error',
    hides=('programs.never-spun', 'turtlesim.slow-commands'),
)
def rate_not_spun(recording: Recording) -> Iterator[Finding]:
    """Report a program that waits in rate.sleep() while no executor spins its node, for example in a constructor."""
    for finding in _of(recording, 'node not spun', 'calls', 'function'):
        if finding.facts['calls'] == 'timer.sleep':
            yield finding


@rule(
    'programs.callback-missing',
    what='{function}() in {node} passes None instead of a function',
    why='with parentheses, Python calls the function at once and passes its return value, which is `None`',
    do='pass the function itself, without parentheses: self.tick, not self.tick()',
    lesson='09_broadcaster_and_listener',
    level='error',
    hides=('programs.died', 'turtlesim.slow-commands'),
)
def callback_missing(recording: Recording) -> Iterator[Finding]:
    """Report a timer or service without a callback."""
    return _of(recording, 'callback missing', 'function', 'process')


@rule(
    'programs.transition-failed',
    what=(
        '{callback}() in {node} raised {raised}',
        '{callback}() in {node} returned {returned} instead of a TransitionCallbackReturn',
    ),
    why='rclpy hides an exception of this callback; after any other result it raises an AttributeError',
    do='return TransitionCallbackReturn.SUCCESS at the end of {callback}()',
    lesson=LESSON,
    level='error',
    hides=('programs.not-activated', 'programs.died'),
)
def transition_failed(recording: Recording) -> Iterator[Finding]:
    """Report a failed transition of a lifecycle node: its callback returned a failure or raised an exception."""
    return _of(recording, 'transition failed', 'raised', 'returned', 'process')


@rule(
    'programs.waits-for-input',
    what='{process} waits for keyboard input, which it cannot receive',
    why='a program that a launch file starts has no keyboard',
    do='start it with `ros2 run` in another terminal, or pass input with `edulaunch launch ... --stdin` or `Session(stdin=...)`',
    lesson=LESSON,
    level='error',
)
def waits_for_input(recording: Recording) -> Iterator[Finding]:
    """Report a program that reads its keyboard without a time limit.

    The rule `terminal_window` reports programs in a terminal window.
    """
    windows = terminal_windows(recording)
    for fact in recording.facts:
        if fact.kind == 'waits for input' and fact.process is not None and fact.process not in windows:
            file, line = fact_place(recording, fact)
            yield found('process', fact.process, file=file, line=line, time_s=fact.time_s)


@rule(
    'launch.terminal-window',
    what='edulaunch cannot open the terminal window of {process}, so the program in it receives no keyboard input',
    why='only a computer with a screen can open windows, and the simulated machine has none',
    do='run the command of {process} in another terminal',
    lesson=LESSON,
    level='info',
)
def terminal_window(recording: Recording) -> Iterator[Finding]:
    """Report a command such as `gnome-terminal -- ros2 run turtlesim turtle_teleop_key` whose program waits for a key."""
    windows = terminal_windows(recording)
    for fact in recording.facts:
        if fact.kind == 'waits for input' and fact.process in windows:
            process = windows[fact.process]
            yield found('process', process.name, file=process.file, line=process.line)
