"""Rules about turtles that do not do what the student intended."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.runs import INTERRUPTS, end_place, ends_by_name, own_nodes, speaker
from edulaunch.engine.nearest import nearest

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

LESSON = '01_first_launch'
SIDE = 11.088889
EDGE = 1e-3
TICK_S = 0.016
FULL_TURN = 6.29
FAST = 20.0
WRITTEN = 4
"""A program with more different speeds than this calculates them."""
TIMEOUT_NS = 1_008_000_000
TWIST = 'geometry_msgs/msg/Twist'


def _calls(recording: Recording, kind: str) -> Iterator[tuple[float, str, str, Any, Any]]:
    """Yield the calls of a service type of turtlesim.

    Each tuple contains the time in seconds, the service, the client, the request, and the reply. Request and reply are wire
    tuples.
    """
    for time_ns, service, type_name, client, request, _, replied, response in recording.rows('calls'):
        if type_name == f'turtlesim/srv/{kind}':
            yield time_ns / 1e9, service, client, request, response if replied is not None else None


@lru_cache(maxsize=1)
def turtles(recording: Recording) -> dict[str, str]:
    """Return the turtlesim node of each turtle that existed during the run, by the absolute name of the turtle."""
    served = {name for kind, name in ends_by_name(recording) if kind == 'service' and name.endswith('/set_pen')}
    found: dict[str, str] = {}
    for (kind, name), ends in ends_by_name(recording).items():
        turtle = name.removesuffix('/pose')
        if kind == 'publisher' and ends[0].type == 'turtlesim/msg/Pose' and f'{turtle}/set_pen' in served:
            found[turtle] = ends[0].node
    return found


@lru_cache(maxsize=1)
def commands(recording: Recording) -> dict[str, list[tuple[int, str, Any]]]:
    """Return the velocity commands for each turtle as (time in nanoseconds, node, wire tuple)."""
    topics = {turtle: f'{turtle}/cmd_vel' for turtle in turtles(recording)}
    return {turtle: recording.published(topic, TWIST) for turtle, topic in topics.items() if topic in recording.topics}


def _asked(recording: Recording, service: str, client: str, time_s: float, turtle: str, **facts: Any) -> Finding:
    """Return a finding about a request, at the line of its client."""
    file, line = end_place(recording, 'client', service, client)
    return found('turtle', turtle, file=file, line=line, time_s=time_s, node=speaker(recording, client), **facts)


def _driven(recording: Recording, turtle: str, node: str, time_s: float, **facts: Any) -> Finding:
    """Return a finding about velocity commands, at the line of their publisher."""
    file, line = end_place(recording, 'publisher', f'{turtle}/cmd_vel', node)
    return found('turtle', turtle, file=file, line=line, time_s=time_s, node=speaker(recording, node), **facts)


@rule(
    'turtlesim.wall',
    what='{turtle} drove into the wall at x={x}, y={y} and pushed against it for {seconds} s',
    why='the field extends from 0 to 11.09 in x and y, and a turtle cannot leave it',
    do=(
        'check the frame that {follower} follows, and the velocities that {follower} calculates from it',
        'subscribe to the pose, and turn when x or y is below 1 or above 10',
    ),
    lesson=LESSON,
)
def wall(recording: Recording) -> Iterator[Finding]:
    """Report a turtle that pushed against an edge of the window for half a second."""
    if not any('I hit the wall' in row[4] for row in recording.rows('logs')):
        return
    followed = ends_by_name(recording).get(('subscription', '/tf'), ())
    for turtle, node in turtles(recording).items():
        at = [
            (time, wire) for time, wire in recording.wires(f'{turtle}/pose', 'turtlesim/msg/Pose') if _at_edge(wire) and wire[3]
        ]
        if len(at) * TICK_S >= 0.5:
            driver = _driver(recording, turtle)
            follower = driver if driver and any(end.node == driver for end in followed) else None
            x, y = (round(value, 2) for value in at[0][1][:2])
            file, line = end_place(recording, 'publisher', f'{turtle}/cmd_vel', driver or node)
            seconds = round(len(at) * TICK_S, 1)
            facts = {'x': x, 'y': y, 'seconds': seconds, 'follower': follower, 'asker': speaker(recording, driver or node)}
            yield found('turtle', turtle, file=file, line=line, time_s=at[0][0] / 1e9, **facts)


def _at_edge(wire: Any) -> bool:
    return bool(min(wire[0], wire[1]) <= EDGE or max(wire[0], wire[1]) >= SIDE - EDGE)


def _driver(recording: Recording, turtle: str) -> str | None:
    return next((node for _, node, _ in commands(recording).get(turtle, ())), None)


@rule(
    'turtlesim.spawn-taken',
    what="{node} cannot spawn '{turtle}', because a turtle with that name already exists",
    why='the reply then has an empty name, and {node} controls a turtle that another node may control too',
    do="use another name, leave the name empty to get a generated one, or kill '{turtle}' first",
    lesson=LESSON,
    level='error',
)
def spawn_taken(recording: Recording) -> Iterator[Finding]:
    """Report a spawn with a name that already existed. In that case, the name in the reply is empty."""
    for time_s, service, client, request, response in _calls(recording, 'Spawn'):
        if response is not None and not response[0]:
            yield _asked(recording, service, client, time_s, request[3])


@rule(
    'turtlesim.outside',
    what='{node} puts {turtle} at x={x}, y={y}, which is outside the field',
    why='the field extends from 0 to 11.09 in x and y, so turtlesim puts the turtle at the edge',
    do='use values between 0 and 11 for x and y; the middle is 5.54',
    lesson=LESSON,
    level='error',
    hides=('turtlesim.wall',),
)
def outside(recording: Recording) -> Iterator[Finding]:
    """Report a spawn or teleport_absolute to a place outside the window."""
    for kind in ('Spawn', 'TeleportAbsolute'):
        for time_s, service, client, request, _ in _calls(recording, kind):
            if not (0 <= request[0] <= SIDE and 0 <= request[1] <= SIDE):
                name = (request[3] or 'a turtle') if kind == 'Spawn' else service.rpartition('/')[0]
                yield _asked(recording, service, client, time_s, name, x=round(request[0], 2), y=round(request[1], 2))


@rule(
    'turtlesim.degrees',
    what='{node} sets the angle of {turtle} to {angle}, which is more than a full turn in radians',
    why='all angles in ROS 2 are in radians: a quarter turn is 1.57, and a full turn is 6.28',
    do='convert the angle: math.radians({angle})',
    lesson=LESSON,
    confidence='asked',
)
def degrees(recording: Recording) -> Iterator[Finding]:
    """Report angles above a full turn, and turning speeds above three turns a second.

    Skip speeds that a controller calculates.
    """
    for kind, at in (('Spawn', 2), ('TeleportAbsolute', 2), ('TeleportRelative', 1)):
        for time_s, service, client, request, _ in _calls(recording, kind):
            if abs(request[at]) > FULL_TURN:
                name = request[3] if kind == 'Spawn' else service.rpartition('/')[0]
                yield _asked(recording, service, client, time_s, name, angle=round(request[at], 2))
    for turtle, rows in commands(recording).items():
        fast = next((row for row in rows if abs(row[2][5]) > FAST), None)
        if fast is not None and len({round(abs(row[2][5]), 2) for row in rows if row[1] == fast[1]}) <= WRITTEN:
            yield _driven(recording, turtle, fast[1], fast[0] / 1e9, angle=round(fast[2][5], 2))


@rule(
    'turtlesim.pen-off',
    what='{node} sets a pen colour for {turtle} but switches the pen off (off={off})',
    why='the turtle draws only if off is 0, and turtlesim ignores the new colour otherwise',
    do='set off=0 to draw',
    lesson=LESSON,
    confidence='asked',
)
def pen_off(recording: Recording) -> Iterator[Finding]:
    """Report a request that sets a colour or width and switches the pen off, if no request switches this pen on."""
    down = {row[1] for row in _calls(recording, 'SetPen') if not row[3][4]}
    for time_s, service, client, request, _ in _calls(recording, 'SetPen'):
        if request[4] and any(request[:4]) and service not in down:
            yield _asked(recording, service, client, time_s, service.rpartition('/')[0], off=request[4])


@rule(
    'turtlesim.kill-unknown',
    what=(
        "the turtle '{again}' cannot be killed a second time, because it does not exist any more",
        "the turtle '{turtle}' cannot be killed, because it does not exist",
    ),
    do=(
        "kill '{again}' only once, and store in your node which turtles it has killed",
        "spawn '{later}' before you kill it",
        "write '{near}' if you mean this name",
        'use the name of an existing turtle: {names}',
        'spawn the turtle first',
    ),
    lesson=LESSON,
    level='error',
)
def kill_unknown(recording: Recording) -> Iterator[Finding]:
    """Report a kill request for an unknown turtle, which turtlesim has logged."""
    names = [turtle.rpartition('/')[2] for turtle in turtles(recording)]
    for time_ns, process, _, _, message in recording.rows('logs'):
        match = _NO_TURTLE.match(message)
        if match is not None:
            asker = next((row[1:3] for row in _calls(recording, 'Kill') if row[3][0] == match[1]), ('', ''))
            file, line = end_place(recording, 'client', *asker)
            time_s, kills = time_ns / 1e9, [row for row in _calls(recording, 'Kill') if row[3][0] == match[1]]
            was_killed = match[1] in names and sum(row[0] <= time_s for row in kills) > 1
            facts = {
                'again': match[1] if was_killed else None,
                'later': match[1] if match[1] in names else None,
                'near': nearest(match[1], names),
                'names': names,
            }
            yield found('turtle', match[1], file=file, line=line, time_s=time_s, process=process, **facts)


@rule(
    'turtlesim.killed',
    what='{node} sends commands to {turtle}, which was already killed',
    why='the topics of a turtle disappear with it, so the commands are lost',
    do="spawn '{short}' again, or stop sending commands when you kill it",
    lesson=LESSON,
    level='error',
)
def killed(recording: Recording) -> Iterator[Finding]:
    """Report commands for a killed turtle, if no spawn with the same name followed the kill."""
    spawned = [(time_s, request[3]) for time_s, _, _, request, _ in _calls(recording, 'Spawn')]
    for time_s, service, _, request, _ in _calls(recording, 'Kill'):
        turtle = f'{service.rpartition("/")[0]}/{request[0]}'
        late = next((row for row in commands(recording).get(turtle, ()) if row[0] / 1e9 > time_s and any(row[2])), None)
        if late is not None and not any(at_s > time_s and name == request[0] for at_s, name in spawned):
            yield _driven(recording, turtle, late[1], late[0] / 1e9, short=request[0])


_NO_TURTLE = re.compile(r'Tried to kill turtle \[(.*)\], which does not exist')


@rule(
    'turtlesim.ignored-axes',
    what='{node} sets only {axes} for {turtle}, and a turtle ignores these fields',
    why='a turtle uses linear.x and angular.z, and linear.y only if the parameter holonomic is true',
    do='set linear.x to drive and angular.z to turn',
    lesson=LESSON,
    level='error',
)
def ignored_axes(recording: Recording) -> Iterator[Finding]:
    """Report a node whose velocity commands contain only components that turtlesim ignores."""
    for turtle, rows in commands(recording).items():
        holonomic = recording.parameters(turtles(recording)[turtle]).get('holonomic')
        counting = (0, 5, 1) if holonomic is not None and holonomic.value else (0, 5)
        for node in dict.fromkeys(row[1] for row in rows):
            used = [any(row[2][axis] for row in rows if row[1] == node) for axis in range(6)]
            if any(used) and not any(used[axis] for axis in counting):
                axes = [name for name, is_used in zip(AXES, used, strict=True) if is_used]
                yield _driven(recording, turtle, node, rows[0][0] / 1e9, axes=axes)


AXES = ('linear.x', 'linear.y', 'linear.z', 'angular.x', 'angular.y', 'angular.z')


@rule(
    'turtlesim.slow-commands',
    what=(
        '{node} sends a command to {turtle} only every {gap_s} s, so the turtle stops in between',
        '{node} sends only one command to {turtle}, so the turtle stops after one second',
    ),
    why='a turtle follows a command for one second and then stops',
    do='send commands from a timer, more often than once a second: self.create_timer(0.1, self.drive)',
    lesson=LESSON,
)
def slow_commands(recording: Recording) -> Iterator[Finding]:
    """Report a student's node that sends velocity commands too rarely: at least half of the gaps are longer than a second."""
    own = own_nodes(recording)
    dead = {process.name for process in recording.processes if process.exception and process.exception['type'] not in INTERRUPTS}
    failed = {node.name for node in recording.nodes if node.process in dead}
    for turtle, rows in commands(recording).items():
        nodes = {row[1] for row in rows}
        moving = [row[0] for row in rows if any(row[2])]
        if len(nodes) != 1 or not nodes <= own or nodes & failed or not moving or len(moving) < len(rows):
            continue
        gaps = sorted(later - before for before, later in zip(moving, moving[1:], strict=False))
        over = recording.duration_s - moving[-1] / 1e9
        middle = gaps[len(gaps) // 2] if gaps else None
        if (middle is None and over > 2.0) or (len(moving) > 2 and middle is not None and middle > TIMEOUT_NS):
            gap_s = None if middle is None else round(middle / 1e9, 2)
            yield _driven(recording, turtle, rows[0][1], moving[0] / 1e9, gap_s=gap_s)
