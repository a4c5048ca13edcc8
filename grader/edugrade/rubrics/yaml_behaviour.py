"""Checks of YAML rubrics that compare the output of a program with the simulated worlds and the topics."""

from __future__ import annotations

import os
import re
from bisect import bisect_right
from collections.abc import Iterable
from math import inf
from typing import Any

from ..evidence import Evidence, Failure, Mismatch, Missing
from ..library.description import joints_of, require_derived
from ..library.following import require_copy, require_driver
from ..library.frames import transforms
from ..library.heard import Program, require_heard, require_lines_of_messages
from ..library.identity import is_stock, rows_of
from ..library.launched import refuse_strangers
from ..library.movement import Track, turtle_track
from ..library.node_graph import require_topic
from ..shortened import last_lines, readable, shortened
from ..source import is_shipped
from .yaml_checks import PROGRAM, kind
from .yaml_wanted import OfRun, Wanted

LEAST_LINES, LONGEST_COMMAND = 3, 100
KINDS_OF_JOINTS = {
    'movable': ('revolute', 'continuous', 'prismatic', 'planar', 'floating'),
    'turning': ('revolute', 'continuous'),
}
FOUND_AFTER_S = 0.5  # by then, a polling recorder has discovered a topic
HEARD_AFTER_S = 1.0  # largest time between a message and the line that prints it
SENT_WITH_S = 0.05  # largest time between a message and the line that counts it


@kind('{node} receives messages', 'node from', PROGRAM)
def receives(run: Evidence, wanted: Wanted) -> None:
    """Require that a node subscribes to a topic on which another program publishes messages, whatever the topic is called."""
    for one in wanted.of_each(run):
        listener, speaker = Program(one.text('node'), *one.program()), Program(*one.other('from'))
        advice = wanted.try_ or f'connect {listener.words} to {speaker.words} with a remapping'
        require_heard(one.alone, one.scenario, listener, speaker, advice)


@kind('{node} logs {pattern}', 'node pattern', f'example topic {PROGRAM}')
def logs(run: Evidence, wanted: Wanted) -> None:
    """Require that a node logs a line that matches a pattern, and that such lines follow the messages of a topic."""
    for one in wanted.of_each(run):
        logger = one.text('node').strip('/').replace('/', '.')
        logs, (package, executable) = one.recording.logs, one.program()
        rows = range(len(logs)) if package is None else rows_of(one.recording, 'logs', package, executable)
        own = [logs[row] for row in rows if logs[row].logger.replace('/', '.') == logger]
        if not _fits(wanted, (log.message for log in own)):
            seen = last_lines([f'{log.message}\n' for log in own]) or 'no log lines'
            asked = wanted['example'] or readable(str(wanted['pattern']))
            thing = f'{one.text("node")} does not log the expected line in the run with {one.words}'
            raise Failure(thing, expected=asked, seen=seen, **one.advice)
        if wanted['topic']:
            lines = [(log.time_s, log.message) for log in own if _fits(wanted, [log.message])]
            listener = Program(one.text('node'), package, executable)
            require_lines_of_messages(one.alone, one.scenario, listener, one.text('topic'), lines, wanted.try_)


@kind('{executable} prints {pattern}', 'package executable pattern', 'example')
def prints(run: Evidence, wanted: Wanted) -> None:
    """Require that a program prints a line that matches a pattern."""
    for one in wanted.of_each(run):
        rows = rows_of(one.recording, 'output', wanted['package'], wanted['executable'])
        lines = [one.recording.output[row].text for row in rows]
        if not _fits(wanted, (line for text in lines for line in text.splitlines())):
            thing = f'the program {wanted["executable"]} does not print the expected line in the run with {one.words}'
            asked = wanted['example'] or readable(str(wanted['pattern']))
            raise Failure(thing, expected=asked, seen=last_lines(lines) or 'no output', **one.advice)


def _fits(wanted: Wanted, lines: Iterable[str]) -> bool:
    pattern = re.compile(str(wanted['pattern']))
    return any(pattern.search(line[:1000]) for line in lines)


@kind('{turtle} copies {original}', 'turtle original')
def copies(run: Evidence, wanted: Wanted) -> None:
    """Require that a turtle drives as far as another turtle, because `mimic` receives the poses of the other turtle."""
    for one in wanted.of_each(run):
        turtle, original = (f'/{one.text(key).strip("/")}' for key in ('turtle', 'original'))
        require_copy(one.alone, original, turtle, wanted.try_ or 'check the remappings of the Node of mimic')
        require_driver(one.alone, turtle, 'turtlesim', 'mimic')


@kind('{executable} counts the messages of {topics}', 'package executable pattern topics')
def counts(run: Evidence, wanted: Wanted) -> None:
    """Require that a program prints the number of messages on some topics. The first group of `pattern` must match the number."""
    for one in wanted.of_each(run):
        times = sorted(time_s for topic in _topics(one) for time_s in _message_times(one, topic))
        lines = _lines(one)
        seen = [(time_s, float(found[1])) for time_s, found in lines]
        thing, advice = f'the count that {wanted["executable"]} prints', _in_program(one)
        if not seen:
            asked = readable(str(wanted['pattern']))
            raise Failure(f'the program {wanted["executable"]} prints no count', expected=asked, seen=_last_lines(one), **advice)
        for time_s, number in seen:
            low, high = bisect_right(times, time_s - SENT_WITH_S), bisect_right(times, time_s + SENT_WITH_S)
            if not (low + 1 if high > low else low) <= number <= high:
                raise Mismatch(thing, f'{high} at {time_s:.2f} s', f'{number:g}', during=one.words, **advice)
        if len(seen) < len(times) - 1:
            asked, words = f'on a line after each of {len(times)} messages', f'{len(seen)} lines'
            raise Mismatch(thing, asked, words, during=one.words, **advice)


def _in_program(one: OfRun) -> dict[str, Any]:
    """Return the advice, with the line of the student's program that contains the beginning of the pattern as its place."""
    text = re.escape(readable(str(one.wanted['pattern'])).partition('NUMBER')[0])
    return one.advice | {'where': one.run.source.place_in(f'{one.wanted["executable"]}.py', text)}


@kind('{executable} counts to {at_least}', 'package executable pattern topics at_least')
def counts_up(run: Evidence, wanted: Wanted) -> None:
    """Require that a program prints numbers that never decrease, reach `at_least`, and never exceed the number of messages
    sent.
    """
    for one in wanted.of_each(run):
        times = sorted(time_s for topic in _topics(one) for time_s in _message_times(one, topic))
        newest, program, advice = 0.0, wanted['executable'], _in_program(one)
        for time_s, found in _lines(one):
            number, sent = float(found[1]), bisect_right(times, time_s + SENT_WITH_S)
            if not newest <= number <= sent:
                thing = f'the number that {program} prints at {time_s:.2f} s'
                asked = f'{sent}' if newest == sent else f'{newest:g} to {sent}'
                raise Mismatch(thing, asked, f'{number:g}', during=one.words, **advice)
            newest = number
        if not newest >= one.number('at_least'):
            asked = readable(str(wanted['pattern'])).replace('NUMBER', f'{one.number("at_least"):g}', 1)
            thing = f'the program {program} does not count to {one.number("at_least"):g} in the run with {one.words}'
            is_rare = len(_lines(one)) < len(times) - 1
            log = f'log a line after each message: {program} logs {len(_lines(one))} of them for {len(times)} messages'
            failure = Failure(thing, expected=asked, seen=_last_lines(one), **advice | ({'try_': log} if is_rare else {}))
            failure.fits_rubric = not is_rare
            raise failure


@kind('{executable} prints the messages of {topic}', 'package executable pattern topic', 'example')
def repeats(run: Evidence, wanted: Wanted) -> None:
    """Require that a program prints each message of a topic soon after it arrives. The first group of
    `pattern` must match the field `data` of the message.
    """
    for one in wanted.of_each(run):
        topic, lines, program = one.text('topic'), _lines(one), wanted['executable']
        if not lines:
            asked = wanted['example'] or readable(str(wanted['pattern']))
            thing = f'the program {program} does not print the expected line in the run with {one.words}'
            raise Failure(thing, expected=asked, seen=_last_lines(one), **one.advice)
        hidden = one.run.scenario(one.scenario).sent.get(topic, (0.0, ''))
        sent = [(time_s, str(getattr(message, 'data', ''))) for time_s, message in one.recording.messages(topic)]
        unprinted = list(sent)
        for time_s, found in lines:
            recent = [text for sent_s, text in sent if time_s - HEARD_AFTER_S <= sent_s <= time_s]
            own = next((each for each in unprinted if time_s - HEARD_AFTER_S <= each[0] <= time_s and each[1] == found[1]), None)
            if own is None:
                thing = f'the line that {program} prints at {time_s:.2f} s'
                asked = 'one line for each message' if found[1] in recent else ' or '.join(dict.fromkeys(recent)) or 'no line'
                raise Mismatch(thing, asked, found[1], during=one.words, **one.advice)
            unprinted.remove(own)
        first_s, last_s = lines[0][0], one.recording.duration_s - HEARD_AFTER_S
        missed = next((each for each in unprinted if first_s < each[0] < last_s or each == hidden), None)
        if missed is not None:
            thing = f'the program {program} does not print the message of {missed[0]:.2f} s in the run with {one.words}'
            raise Failure(thing, expected=missed[1], seen=_last_lines(one), **one.advice)


@kind('{executable} prints where {turtle} was {ago} s ago', 'package executable pattern turtle ago', 'tolerance example frame')
def tells_place(run: Evidence, wanted: Wanted) -> None:
    """Require that a program prints an earlier position of a turtle. The groups of `pattern` must match x, y and the age in
    seconds.

    With `frame`, the program must get the position from tf2, so it cannot print a position before the first transform of this
    frame. The program must not subscribe to the poses of the turtle.
    """
    for one in wanted.of_each(run):
        track = turtle_track(one.recording, f'/{one.text("turtle").strip("/")}/pose')
        lines, known_s = _lines(one), _first_transform_s(one)
        _refuse_poses(one)
        if len(lines) < LEAST_LINES:
            asked, advice = wanted['example'] or readable(str(wanted['pattern'])), one.advice
            if re.search(rf'{str(wanted["pattern"]).partition("(")[0]}-?[\d.]', _last_lines(one)):
                advice = {**advice, 'try_': 'compare the numbers and the form of the line with the line "expected"'}
            raise Failure(
                f'the program {wanted["executable"]} prints {len(lines)} lines of the expected form in the run with {one.words}',
                expected=f'at least {LEAST_LINES} lines such as\n{asked}',
                seen=_last_lines(one),
                **advice,
            )
        for time_s, found in lines:
            x, y, age = (float(found[group]) for group in (1, 2, 3))
            asked, thing = one.number('ago'), f'the position that {wanted["executable"]} prints at {time_s:.2f} s'
            if time_s < known_s:
                first = f'none before {known_s:.2f} s, the time of the first transform of {wanted["frame"]}'
                raise Mismatch(thing, first, f'({x:.2f}, {y:.2f})', **one.advice)
            if not abs(age - asked) <= 0.06:
                raise Mismatch(thing, f'{asked:g} s old', f'{age:g} s old', **one.advice)
            away = _distance(track, time_s - age, x, y)
            if not away <= one.tolerance(0.05):
                place = _at(track, time_s - age)
                if place is None:
                    raise Failure(f'{thing} is from before the first pose', seen=f'({x:.2f}, {y:.2f})', **one.advice)
                raise Mismatch(thing, f'({place[1]:.2f}, {place[2]:.2f})', f'({x:.2f}, {y:.2f})', **one.advice)


def _first_transform_s(one: OfRun) -> float:
    """Return the time of the first transform of `frame`, or 0.0 for a check without `frame`."""
    frame = one.wanted['frame']
    sent = transforms(one.run, one.scenario).get(frame, ()) if frame else ()
    return min((item.time_s for item in sent), default=inf if frame else 0.0)


def _refuse_poses(one: OfRun) -> None:
    """Refuse a node of the student that receives the poses of the turtle, in a check with `frame`.

    Such a node needs no tf2 to know the position, and can send it to the other programs.
    """
    topic = f'/{one.text("turtle").strip("/")}/pose'
    for position, node in enumerate(one.recording.nodes if one.wanted['frame'] else ()):
        if topic not in (name for name, _ in node.subscriptions) or is_stock(one.recording, position):
            continue
        thing = f'{node.name} receives the positions on {topic}, and not only from tf2, in the run with {one.words}'
        asked, advice = f'no subscription to {topic}', f'remove this subscription, and look up {one.wanted["frame"]} in a Buffer'
        raise Failure(thing, expected=asked, seen=f'a subscription to {topic}', where=one.run.source.place, try_=advice)


def _topics(one: OfRun) -> list[str]:
    return [one.filled(topic) for topic in one.wanted['topics']]


def _message_times(one: OfRun, topic: str) -> list[float]:
    require_topic(one.run, one.scenario, topic, try_=one.wanted.try_)
    return [time_s for time_s, _ in one.recording.messages(topic)]


def _lines(one: OfRun) -> list[tuple[float, re.Match[str]]]:
    """Return (time, match) for each line of the program's output that matches the pattern."""
    pattern, found = re.compile(str(one.wanted['pattern'])), []
    for row in rows_of(one.recording, 'output', one.wanted['package'], one.wanted['executable']):
        output = one.recording.output[row]
        found += [(output.time_s, match) for line in output.text.splitlines() if (match := pattern.search(line[:1000]))]
    return found


def _last_lines(one: OfRun) -> str:
    rows = rows_of(one.recording, 'output', one.wanted['package'], one.wanted['executable'])
    return last_lines([one.recording.output[row].text for row in rows]) or 'no output'


def _at(track: Track, time_s: float) -> tuple[float, float, float] | None:
    position = bisect_right([sample[0] for sample in track], time_s) - 1
    return track[position] if position >= 0 else None


def _distance(track: Track, time_s: float, x: float, y: float) -> float:
    """Return the larger coordinate difference, in metres, between a position and the turtle at about that time.

    Without a pose at that time, the result is infinite.
    """
    near = [sample for sample in track if abs(sample[0] - time_s) <= 0.05]
    return min((max(abs(sample[1] - x), abs(sample[2] - y)) for sample in near), default=float('inf'))


@kind('The robot description has a joint from {parent} to {child}', 'child parent', 'joint')
def described(run: Evidence, wanted: Wanted) -> None:
    """Require a joint between two links in the robot description on /robot_description, and transforms that follow from it.

    The value of `joint` is 'movable', 'turning' or a joint type.
    """
    for one in wanted.of_each(run):
        found = require_topic(one.run, one.scenario, '/robot_description', try_=wanted.try_)
        refuse_strangers(one.recording, found.name, 'robot_state_publisher')
        texts = [message.data for _, message in one.recording.messages(found.name) if hasattr(message, 'data')]
        joints = joints_of(str(texts[-1])) if texts else {}
        child, parent = one.text('child'), one.text('parent')
        known = joints.get(child)
        if known is None or known.parent != parent:
            seen = ', '.join(f'{joint.parent} to {link}' for link, joint in joints.items()) or 'no joint'
            thing, advice = (
                f'the joint from {parent} to {child} in the robot description',
                f'add a joint from {parent} to {child}',
            )
            raise Missing(thing, seen=seen, where=run.source.place, try_=wanted.try_ or advice)
        asked = str(wanted['joint'] or known.kind)
        kinds = KINDS_OF_JOINTS.get(asked, (asked,))
        if known.kind not in kinds:
            types = ' or '.join(kinds)
            thing, advice = f'the type of the joint from {parent} to {child}', f'write {types} as the type of the joint'
            raise Mismatch(thing, types, known.kind or 'no type', where=run.source.place, try_=wanted.try_ or advice)
        require_derived(one.run, one.scenario, child, known, wanted.try_)


@kind('A bag contains the messages on {topic}', 'topic', 'package')
def bag(run: Evidence, wanted: Wanted) -> None:
    """Require a bag with the messages of a topic after launch has received Ctrl-C. Only `package` may publish the topic."""
    for one in wanted.of_each(run):
        topic, bags = one.text('topic'), run.bags[one.scenario]
        require_topic(one.run, one.scenario, topic, None, wanted['package'] or None, wanted.try_)
        times = [time_s for time_s, _ in one.recording.messages(topic)]
        late = [time_s for time_s in times if time_s >= times[0] + FOUND_AFTER_S]
        if not bags:
            thing, asked = f'the run with {one.words} leaves no bag', f'a bag with the messages on {topic}'
            raise Failure(thing, expected=asked, seen='no bag after Ctrl-C', **one.advice)
        counts = [each['topics'][topic] for each in bags if topic in each['topics']]
        if not counts:
            known = sorted({name for each in bags for name in each['topics']})
            thing = f'the bag has no messages on {topic} in the run with {one.words}'
            raise Failure(thing, expected=topic, seen=', '.join(known) or 'bags without messages', **one.advice)
        count, known = max(counts, key=lambda each: each[1])
        if not len(late) <= known == count:
            seen = f'{count} messages, of which {known} were published'
            raise Mismatch(f'the content of the bag for {topic}', f'the {len(times)} published messages', seen, **one.advice)


@kind('The launch file is written in {format}', 'format')
def written_in(run: Evidence, wanted: Wanted) -> None:
    """Require that the launch file and the files that start its nodes have a format. Files of edulaunch may have any format."""
    ending = f'.{str(wanted["format"]).lower()}'
    for one in wanted.of_each(run):
        started = [process.file for process in one.recording.processes if process.file]
        files = [run.source.file, *one.recording.includes, *started]
        other = next((file for file in files if not file.endswith(ending) and not is_shipped(file)), None)
        if other is not None:
            seen = os.path.basename(other)
            raise Mismatch('the format of the launch file', f'.launch{ending}', seen, **one.advice)


@kind('The launch file runs {words}', 'words')
def command(run: Evidence, wanted: Wanted) -> None:
    """Require that the launch file or one of its programs runs a command."""
    asked = str(wanted['words']).split()
    for one in wanted.of_each(run):
        lines = [' '.join(process.argv).split() for process in one.recording.processes]
        known = [[os.path.basename(line[0]), *line[1:]] for line in lines if line]
        if not any(line[place : place + len(asked)] == asked for line in known for place in range(len(line))):
            seen = '\n'.join(shortened(' '.join(line), LONGEST_COMMAND) for line in known[1:]) or 'no command'
            advice = wanted.try_ or f'start {wanted["words"]} with an ExecuteProcess in the launch description'
            raise Missing(f'the command {wanted["words"]}', seen=seen, where=run.source.place, try_=advice)
