"""Checks of a YAML rubric that compare what a program reports with what happened in the worlds and on the topics."""

from __future__ import annotations

import os
import re
from bisect import bisect_right

from ..evidence import Evidence, Mismatch, Missing
from ..library.identity import rows_of
from ..library.launched import refuse_strangers
from ..library.movement import Track, turtle_track
from ..library.node_graph import require_topic
from ..shortened import last_lines, readable
from ..source import is_shipped
from .yaml_checks import kind
from .yaml_wanted import OfRun, Wanted

LEAST_LINES = 3
FOUND_AFTER_S = 0.5  # a recorder that polls has found a topic by then
SENT_WITH_S = 0.05  # a line may come this long before or after the message that it counts


@kind('{executable} counts the messages of {topics}', 'package executable pattern topics')
def counts(run: Evidence, wanted: Wanted) -> None:
    """A program prints how many messages came on some topics, after each of them. The first group of `pattern` is the number."""
    for one in wanted.of_each(run):
        times = sorted(time_s for topic in _topics(one) for time_s in _message_times(one, topic))
        lines = _lines(one)
        seen = [(time_s, float(found[1])) for time_s, found in lines]
        thing = f'the count that {wanted["executable"]} prints, when launched with {one.words},'
        if not seen:
            raise Missing(f'a count in what {wanted["executable"]} prints', seen=_last_lines(one), **one.advice)
        for time_s, number in seen:
            low, high = bisect_right(times, time_s - SENT_WITH_S), bisect_right(times, time_s + SENT_WITH_S)
            if not low <= number <= high:
                raise Mismatch(thing, f'{high} at {time_s:.2f} s', f'{number:g}', **one.advice)
        if len(seen) < len(times) - 1:
            raise Mismatch(thing, f'a line after each of {len(times)} messages', f'{len(seen)} lines', **one.advice)


@kind('{executable} says where {turtle} was {ago} s ago', 'package executable pattern turtle ago', 'tolerance example')
def tells_place(run: Evidence, wanted: Wanted) -> None:
    """A program prints where a turtle was some time ago. The groups of `pattern` are x, y and the age in seconds."""
    for one in wanted.of_each(run):
        track = turtle_track(one.recording, f'/{one.text("turtle").strip("/")}/pose')
        lines = _lines(one)
        if len(lines) < LEAST_LINES:
            thing = f'{LEAST_LINES} such lines in what {wanted["executable"]} prints, when launched with {one.words}'
            raise Missing(
                thing, expected=wanted['example'] or readable(str(wanted['pattern'])), seen=_last_lines(one), **one.advice
            )
        for time_s, found in lines:
            x, y, age = (float(found[group]) for group in (1, 2, 3))
            asked, thing = one.number('ago'), f'what {wanted["executable"]} says at {time_s:.2f} s'
            if not abs(age - asked) <= 0.06:
                raise Mismatch(thing, f'a place that is {asked:g} s old', f'{age:g} s old', **one.advice)
            away = _distance(track, time_s - age, x, y)
            if not away <= one.tolerance(0.05):
                place = _at(track, time_s - age)
                advice = (
                    f'({place[1]:.2f}, {place[2]:.2f}), where {wanted["turtle"]} was' if place else 'no line: nobody knew it then'
                )
                raise Mismatch(thing, advice, f'({x:.2f}, {y:.2f})', **one.advice)


def _topics(one: OfRun) -> list[str]:
    return [one.filled(topic) for topic in one.wanted['topics']]


def _message_times(one: OfRun, topic: str) -> list[float]:
    require_topic(one.run, one.scenario, topic, try_=one.wanted.try_)
    return [time_s for time_s, _ in one.recording.messages(topic)]


def _lines(one: OfRun) -> list[tuple[float, re.Match[str]]]:
    """The lines of the program's output that fit the pattern, with their times."""
    pattern, found = re.compile(str(one.wanted['pattern'])), []
    for row in rows_of(one.recording, 'output', one.wanted['package'], one.wanted['executable']):
        output = one.recording.output[row]
        found += [(output.time_s, match) for line in output.text.splitlines() if (match := pattern.search(line[:1000]))]
    return found


def _last_lines(one: OfRun) -> str:
    rows = rows_of(one.recording, 'output', one.wanted['package'], one.wanted['executable'])
    return last_lines([one.recording.output[row].text for row in rows]) or 'nothing is printed'


def _at(track: Track, time_s: float) -> tuple[float, float, float] | None:
    position = bisect_right([sample[0] for sample in track], time_s) - 1
    return track[position] if position >= 0 else None


def _distance(track: Track, time_s: float, x: float, y: float) -> float:
    """How far a place is from where the turtle was at about that time, in m; infinite where nobody knows."""
    near = [sample for sample in track if abs(sample[0] - time_s) <= 0.05]
    return min((max(abs(sample[1] - x), abs(sample[2] - y)) for sample in near), default=float('inf'))


@kind('robot_state_publisher has a description in which {child} hangs on {parent}', 'child parent')
def described(run: Evidence, wanted: Wanted) -> None:
    """The description of a robot that came on /robot_description has a joint between two links."""
    for one in wanted.of_each(run):
        found = require_topic(one.run, one.scenario, '/robot_description', try_=wanted.try_)
        refuse_strangers(one.recording, found.name, 'robot_state_publisher')
        texts = [message.data for _, message in one.recording.messages(found.name) if hasattr(message, 'data')]
        links = _links(str(texts[-1])) if texts else {}
        child, parent = one.text('child'), one.text('parent')
        if links.get(child) != parent:
            seen = ', '.join(f'{link} on {above}' for link, above in links.items()) or 'no joint'
            raise Missing(f'a joint from {parent} to {child} in the description', seen=seen, **one.advice)


def _links(text: str) -> dict[str, str]:
    """The parent of each link that a robot description names, by the link; nothing for text that is no description."""
    from xml.etree import ElementTree

    try:
        joints = list(ElementTree.fromstring(text).iter('joint'))
    except (ElementTree.ParseError, ValueError):
        return {}
    ends = [tuple(joint.find(end) for end in ('child', 'parent')) for joint in joints]
    return {child.get('link', ''): parent.get('link', '') for child, parent in ends if child is not None and parent is not None}


@kind('A bag holds what was published on {topic}', 'topic')
def bag(run: Evidence, wanted: Wanted) -> None:
    """Launch gets Ctrl-C at the end, and a bag that was written has the messages of a topic as they were published."""
    for one in wanted.of_each(run):
        topic, bags = one.text('topic'), run.bags[one.scenario]
        require_topic(one.run, one.scenario, topic, try_=wanted.try_)
        times = [time_s for time_s, _ in one.recording.messages(topic)]
        late = [time_s for time_s in times if time_s >= times[0] + FOUND_AFTER_S]
        thing = f'a bag with the messages of {topic}, when launched with {one.words},'
        if not bags:
            raise Missing(thing, seen='no bag is written when launch is interrupted', **one.advice)
        counts = [each['topics'][topic] for each in bags if topic in each['topics']]
        if not counts:
            known = sorted({name for each in bags for name in each['topics']})
            raise Missing(thing, name=topic, among=known, seen=', '.join(known) or 'bags without messages', **one.advice)
        count, known = max(counts, key=lambda each: each[1])
        if not len(late) <= known == count:
            seen = f'{count} messages in the bag, {known} of which were published'
            raise Mismatch(f'what the bag holds of {topic}', f'{len(times)} messages as they were published', seen, **one.advice)


@kind('The launch file is written in {format}', 'format')
def written_in(run: Evidence, wanted: Wanted) -> None:
    """The file itself is of this format, and what it starts stands in files of this format; stock files may be of any."""
    ending = f'.{str(wanted["format"]).lower()}'
    for one in wanted.of_each(run):
        started = [process.file for process in one.recording.processes if process.file]
        files = [run.source.file, *one.recording.includes, *started]
        other = next((file for file in files if not file.endswith(ending) and not is_shipped(file)), None)
        if other is not None:
            seen = os.path.basename(other)
            raise Mismatch('the format of the launch file', f'a file that ends in .launch{ending}', seen, **one.advice)


@kind('The launch file runs {words}', 'words')
def command(run: Evidence, wanted: Wanted) -> None:
    """A command is started, by the launch file or by one of its programs."""
    asked = str(wanted['words']).split()
    for one in wanted.of_each(run):
        lines = [' '.join(process.argv).split() for process in one.recording.processes]
        known = [[os.path.basename(line[0]), *line[1:]] for line in lines if line]
        if not any(line[place : place + len(asked)] == asked for line in known for place in range(len(line))):
            seen = '\n'.join(' '.join(line)[:100] for line in known[1:]) or 'nothing'
            raise Missing(f'the command {wanted["words"]}', seen=seen, **one.advice)
