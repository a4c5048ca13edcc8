"""Build the content of the tab Launch for a page without scripts. It shows the state of the launch at the end of the run.

The HTML consists of lists and of elements that open and close, so it works with a keyboard and a screen reader.
"""

from __future__ import annotations

import json
import os
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from html import escape
from typing import Any

Row = Mapping[str, Any]
SCOPES = frozenset(
    ('PushLaunchConfigurations', 'PopLaunchConfigurations', 'PushEnvironment', 'PopEnvironment', 'ResetEnvironment')
)
"""Actions that launch itself adds around a group."""
DEEPEST = 40
MOST_ROWS = 1000
MOST_EVENTS = 200
"""The largest numbers of levels, steps and events with which the page is still readable."""
STYLE = """<style>
.launch-outline{--bad:#a3231f;--lit:#8a4500;--soft:#555;--rule:#8a8a8a;overflow-wrap:anywhere}
@media(prefers-color-scheme:dark){.launch-outline{--bad:#ff8f86;--lit:#ffb454;--soft:#b4b8be;--rule:#767b84}}
.launch-outline ul,.launch-outline ol{padding-left:1.3em;margin:.1em 0}
.launch-outline ul{list-style:none}
.launch-outline p{margin:.1em 0 .1em 1.3em}
.launch-outline small{color:var(--soft)}
.launch-outline .left-out{text-decoration:line-through}
.launch-outline .failed{color:var(--bad);font-weight:bold}
.launch-outline small.idle{color:var(--lit);font-weight:bold}
.launch-outline td,.launch-outline th{text-align:left;vertical-align:top;padding:.1em .8em .1em 0}
.launch-outline th{font-weight:normal;color:var(--soft)}
</style>"""


def launch_outline(launches: Iterable[Row], end_us: int) -> str:
    """Return the launches of a run as HTML, or an empty string if the run has no launch.

    Every string is escaped, because programs choose the strings.

    :param launches: the part `launches` of a timeline, with times in microseconds since the start.
    :param end_us: the length of the run in microseconds.
    """
    parts = [''.join(_launch(launch['rows'], end_us)) for launch in launches if launch['rows']]
    return f'{STYLE}<div class="launch-outline">{"".join(parts)}</div>' if parts else ''


def _launch(rows: Sequence[Row], end_us: int) -> Iterator[str]:
    """Yield the HTML of a launch: its tree of actions, and the table of its events."""
    steps = {row['number']: row for row in sorted(rows, key=lambda row: row['number'])}
    below: dict[int, list[Row]] = defaultdict(list)
    above: dict[int, list[int]] = {-1: []}
    for number, row in list(steps.items())[:MOST_ROWS]:
        around = above.get(row['parent'], [])
        above[number] = [*around, number][:DEEPEST]
        if row['kind'] != 'event':
            below[around[-1] if around else -1].append(row)
    yield f'<ul>{"".join(_branch(below, steps, -1, end_us))}</ul>'
    if len(steps) > MOST_ROWS:
        yield f'<p>This page shows the first {MOST_ROWS} of {len(steps)} actions and events.</p>'
    yield from _events(steps, end_us)


def _branch(below: Mapping[int, list[Row]], steps: Mapping[int, Row], number: int, end_us: int) -> Iterator[str]:
    for row in below.get(number, ()):
        inner = ''.join(_branch(below, steps, row['number'], end_us))
        if row['kind'] in SCOPES or (row.get('file') is None and row['kind'] != 'include'):
            yield inner
            continue
        if not row['order'] and row['parent'] in steps and not steps[row['parent']]['order']:
            continue
        look, words = state_of(row, steps, end_us)
        line = (
            f'<span class="{look}">{_text(titled(row))}</span> <small class="{look if look in ("failed", "idle") else "state"}">'
            f'{_text(words)}</small> <small>{_text(place_of(row))}</small>'
        )
        facts = ''.join(_facts(row))
        if not facts and not inner:
            yield f'<li>{line}</li>'
            continue
        state = ' open' if inner or look == 'failed' else ''
        yield f'<li><details{state}><summary>{line}</summary>{facts}{f"<ul>{inner}</ul>" if inner else ""}</details></li>'


def titled(row: Row) -> str:
    """Return the title of a step. The title of an include contains the name of its file without the folder."""
    return f'include {os.path.basename(row["text"])}' if row['kind'] == 'include' else row['text']


def place_of(row: Row) -> str:
    """Return the file and line that created a step, such as 'demo.launch.py:12', or an empty string."""
    return f'{os.path.basename(row["file"])}:{row["line"]}' if row.get('file') else ''


def state_of(row: Row, steps: Mapping[int, Row], end_us: int) -> tuple[str, str]:
    """Return the state of a step at the end of the run, as a CSS class and a description.

    :param row: the step, with times in microseconds.
    :param steps: all steps of the launch, by number.
    :param end_us: the length of the run in microseconds.
    """
    if not row['order'] or row['time'] is None or row['time'] > end_us:
        return 'waiting', _waits(row, steps)
    if row['state'] == 'failed':
        return 'failed', f'failed: {row.get("error", "")}'
    if row['state'] == 'left out':
        return 'left-out', f'left out: {_reason(row)}'
    if row.get('process') and row.get('runs'):
        return _of_process(row['runs'], end_us)
    fired = [time for time in row.get('fired_at', ()) if time <= end_us]
    if row.get('due') is not None:
        return _of_timer(row['due'], fired, steps, end_us)
    if row.get('handlers'):
        times = 'once' if len(fired) == 1 else f'{len(fired)} times'
        return ('taken', f'fired {times}') if fired else ('idle', 'never fired')
    return 'taken', 'is visited' if row['state'] == 'visiting' else 'done'


def _reason(row: Row) -> str:
    """Return why an action was skipped: the launch configurations that its condition reads, or the condition itself."""
    read = [f'{one["name"]} is {_value(one["value"])}' for one in row.get('values', ()) if one['kind'] == 'reason']
    return ', '.join(read) or f'{row.get("condition")} is not true'


def _waits(row: Row, steps: Mapping[int, Row]) -> str:
    parent = steps.get(row['parent'], {})
    if parent.get('due') is not None:
        return 'waits for the timer'
    return 'waits for the event' if parent.get('handlers') else 'waiting'


def _of_process(runs: Sequence[Sequence[Any]], end_us: int) -> tuple[str, str]:
    pid, _, ended, code = runs[-1]
    again = f', run {len(runs)}' if len(runs) > 1 else ''
    if ended is None or ended > end_us:
        return 'running', f'running, pid {pid}{again}'
    if code == 0:
        return 'ended', f'ended, exit code 0{again}'
    return 'failed', (f'ended by signal {-code}' if (code or 0) < 0 else f'died, exit code {code}') + again


def _of_timer(due: int, fired: Sequence[int], steps: Mapping[int, Row], end_us: int) -> tuple[str, str]:
    if fired:
        return 'taken', f'ran out at {fired[0] / 1e6:.2f} s'
    over = [row for row in steps.values() if row.get('event') == 'Shutdown' and (row['time'] or 0) <= end_us]
    return ('left-out', 'cancelled by the shutdown') if over else ('waiting', f'fires at {due / 1e6:.2f} s')


def _facts(row: Row) -> Iterator[str]:
    """Yield HTML with the known facts about a step, except its state."""
    for text in row.get('handlers', ()):
        yield f'<p>Waits for {_text(text)}.</p>'
    for _, text, file, line in row['details']:
        place = f' <small>{_text(os.path.basename(file))}:{line}</small>' if file else ''
        yield f'<p>{_text(text)}{place}</p>'
    if row.get('values'):
        rows = ''.join(
            f'<tr><td>{_text("" if one["kind"] == "reason" else one["kind"])} {_text(one["name"])}</td>'
            f'<td>{_text(_value(one["value"]))}</td><td>{_chain(one["chain"])}</td></tr>'
            for one in row['values']
        )
        yield f'<table>{_head("name", "value", "where it comes from")}{rows}</table>'


def _chain(steps: Sequence[Row]) -> str:
    """Return HTML with the origins of a value, from the first one to the effective one."""
    if not steps:
        return 'nothing sets it'
    lines = []
    for step in steps:
        counts = ' (counts)' if step['counts'] and len(steps) > 1 else ''
        inner = _chain(step['argument']) if step.get('argument') else ''
        is_told = step.get('file') and step['origin'].endswith(f'{os.path.basename(step["file"])} line {step["line"]}')
        place = f' <small>{_text(place_of(step))}</small>' if step.get('file') and not is_told else ''
        lines.append(f'<li>{_text(_value(step["value"]))} — {_text(step["origin"])}{place}{counts}{inner}</li>')
    return f'<ol>{"".join(lines)}</ol>'


def _events(steps: Mapping[int, Row], end_us: int) -> Iterator[str]:
    """Yield the table of events in the order in which they happened. Each row contains the handlers that the event triggered."""
    rows = [row for row in steps.values() if row['kind'] == 'event' and row['time'] is not None and row['time'] <= end_us]
    if not rows:
        return
    rows.sort(key=lambda row: row['order'])
    lines = []
    for row in rows[:MOST_EVENTS]:
        fired = [steps[number] for number in row.get('fired', ()) if number in steps]
        names = ', '.join(f'{step["text"]} ({place_of(step)})' for step in fired) or '–'
        lines.append(f'<tr><td>{row["time"] / 1e6:.3f}</td><td>{_text(row["text"])}</td><td>{_text(names)}</td></tr>')
    more = f'<p>{len(rows) - MOST_EVENTS} more events follow.</p>' if len(rows) > MOST_EVENTS else ''
    head = _head('time (s)', 'event', 'handlers that fired')
    yield f'<details><summary>Events of this launch: {len(rows)}</summary><table>{head}{"".join(lines)}</table>{more}</details>'


def _head(*words: str) -> str:
    return f'<tr>{"".join(f"<th scope=col>{word}</th>" for word in words)}</tr>'


def _value(value: Any) -> str:
    if value is None:
        return 'not set'
    return f"'{value}'" if isinstance(value, str) else json.dumps(value, ensure_ascii=False, default=str)


def _text(text: str) -> str:
    """Return a string as escaped HTML text. A question mark replaces each character that HTML does not allow."""
    return escape(''.join(sign if sign.isprintable() or sign in '\n\t' else '?' for sign in text))
