"""Rules about programs that ended with an error, interrupted runs, and output that no screen showed."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.errors.about import in_share
from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import script_of, walked
from edulaunch.advice.runs import fact_place

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import ProcessRecord

ENDED_WELL = (None, 0, -1, -2, -13, -15)
"""Exit codes of a program that still runs, has finished, or was ended by its closed terminal (`| head`, too), Ctrl-C or
launch.
"""
INTERRUPTED = '[ros2run]: Interrupt'
"""The message of `ros2 run` when Ctrl-C has ended its program, however that program has ended."""
LONGEST = 400
_OUTSIDE = re.compile("timed out|Connection (?:refused|reset)|unreachable|No route to host|Name or service not known|'/dev/")
"""What an error says if a device or another computer does not answer."""
HELP = 'help: '
_REQUIRED = re.compile(r"main\(\) missing 1 required positional argument: '(\w+)'")
_ENDED = re.compile(r'\[ERROR\] \[(?P<name>[^\]]+)\]: process has died \[pid \d+, exit code (?P<code>-?\d+), cmd ')


@rule(
    'programs.private-name',
    what='{node} sets self.{attribute}, but the real rclpy uses that name in every node',
    why='edulaunch does not use that name, but with the real rclpy the node can fail',
    do='choose another name, such as self.my{attribute}',
)
def private_name(recording: Recording) -> Iterator[Finding]:
    """Report an attribute of a student's node that replaces a private attribute of the real rclpy."""
    for fact in recording.facts:
        if fact.kind == 'private name':
            file, line = fact_place(recording, fact)
            yield found('node', fact.data['node'], file=file, line=line, node=fact.data['node'], attribute=fact.data['attribute'])


@rule(
    'programs.died',
    what=('{process} died with exit code {code} ({error})', '{process} died with exit code {code}'),
    why='the other programs continue without it, and launch itself reports success',
    do=(
        'install the program {absent} on this computer',
        'check that the device or program with which line {waits} communicates is on and reachable',
        'check the values that lead to line {raised}, where the program raises this error itself',
        'add a default value, as in `def main({required}=None):`',
        'correct line {at}, where the program ended',
        '{help}',
        'check the last output of the program: {said}',
        'check the last output of the program',
    ),
    lesson='01_first_launch',
    level='error',
)
def died(recording: Recording) -> Iterator[Finding]:
    """Report a program that ended with an error."""
    for process in recording.processes:
        if process.returncode in ENDED_WELL or _is_child(recording, process) or _is_launch(recording, process):
            continue
        printed = _output_lines(recording, process)
        if _is_command(process) and process.returncode == 2 and not any(': error: ' in line for line in printed):
            continue
        if _is_command(process) and any(INTERRUPTED in row.text for row in recording.output if row.process == process.name):
            continue
        error = process.exception or {}
        file, line = (error['file'], error['line']) if error.get('file') else (process.file, process.line)
        yield found(
            'process',
            process.name,
            file=file,
            line=line,
            time_s=process.ended_s,
            code=process.returncode,
            at=error.get('line'),
            required=required[1] if (required := _REQUIRED.match(error.get('message', ''))) else None,
            **_reason(error),
            **{'error': _short(f'{error["type"]}: {error["message"]}') if error else None, **_last_words(printed)},
        )
    yield from _outside(recording)


def _outside(recording: Recording) -> Iterator[Finding]:
    """Yield the programs that are not simulated, such as `python3 misspelt.py`, and that ended with an error.

    Launch logs their end.
    """
    ours = {process.name for process in recording.processes}
    launches = {'launch', *(process.name for process in recording.processes if process.argv[:2] == ['ros2', 'launch'])}
    lines = [line for row in recording.output if row.process in launches for line in row.text.splitlines()]
    for end in filter(None, map(_ENDED.match, lines)):
        name, code = end['name'], int(end['code'])
        if name not in ours and code not in ENDED_WELL:
            printed = [line.removeprefix(f'[{name}] ') for line in lines if line.startswith(f'[{name}] ')]
            yield found(
                'process', name, file=recording.launch.file, code=code, **{'at': None, 'error': None, **_last_words(printed)}
            )


def _reason(error: dict[str, Any]) -> dict[str, Any]:
    """Return facts about the line that ended a program: a command that is `absent`, a device that `waits`, or an own `raised`."""
    message, line = error.get('message', ''), error.get('line')
    tree = script_of(error.get('file'))
    there = [node for node in walked(tree) if getattr(node, 'lineno', None) == line] if tree else []
    absent = re.search(r"No such file or directory: '([\w-]+)'", message)
    if absent and any(isinstance(node, ast.Name) and node.id == 'subprocess' for node in there):
        return {'absent': absent[1]}
    raised = line if any(isinstance(node, ast.Raise) for node in there) else None
    return {'waits': line} if _OUTSIDE.search(message) else {'raised': raised}


def _last_words(printed: list[str]) -> dict[str, Any]:
    """Return facts about the last lines of a program's output.

    They are the `help` of a command of edulaunch, or the last line that contains an error as `said`. The last line of a C++
    program, `terminate called ...`, contains less information than its log.
    """
    if not printed:
        return {}
    if printed[-1].startswith(HELP):
        message = {'error': _short(printed[-2])} if printed[:-1] else {}
        return {'help': printed[-1].removeprefix(HELP), **message}
    told = next((line for line in reversed(printed) if '[ERROR]' in line or '[FATAL]' in line), printed[-1])
    return {'said': _short(in_share(told))}


def _short(text: str) -> str:
    """Return the first line of a message. A long line is shortened."""
    line = text.partition('\n')[0]
    return line if len(line) <= LONGEST else f'{line[:LONGEST].rpartition(" ")[0] or line[:LONGEST]} ...'


def _is_launch(recording: Recording, process: ProcessRecord) -> bool:
    """Return whether this program is the `ros2 launch` of the recording. Other rules report its end."""
    return process.argv[:3] == ['ros2', 'launch', recording.launch.file]


def _is_command(process: ProcessRecord) -> bool:
    return os.path.basename(process.argv[0]) == 'ros2'


def _is_child(recording: Recording, process: ProcessRecord) -> bool:
    """Return whether an earlier program with the same name was still running when this program started."""
    for other in recording.processes:
        if other is process:
            return False
        runs_on = other.ended_s is None or process.started_s < other.ended_s or process.ended_s == other.ended_s
        if other.name == process.name and other.started_s <= process.started_s and runs_on:
            return True
    return False


def _output_lines(recording: Recording, process: ProcessRecord) -> list[str]:
    """Return the lines that a program wrote to standard error."""
    text = ''.join(row.text for row in recording.output if row.process == process.name and row.stream == 'stderr')
    return [line.strip() for line in text.splitlines() if line.strip()]


@rule(
    'programs.interrupted',
    what='the run was interrupted, so later events are not in the recording',
    do='run it again, with a smaller duration_s if it takes too long',
    level='info',
)
def interrupted(recording: Recording) -> Iterator[Finding]:
    """Report a run that Ctrl-C or the interrupt button of a notebook ended."""
    for note in recording.notes:
        if note.kind == 'interrupted':
            yield found('run', recording.launch.file, time_s=note.time_s)


TERMINALS = ('gnome-terminal', 'konsole', 'xterm', 'x-terminal-emulator')


def terminal_windows(recording: Recording) -> dict[str, ProcessRecord]:
    """Return the programs that would open a terminal window on a real computer, by name."""
    return {process.name: process for process in recording.processes if os.path.basename(process.argv[0]) in TERMINALS}


@rule(
    'launch.output-hidden',
    what='{process} prints "{text}", but the screen does not show it',
    why="a Node has output='log' by default, so the screen shows only its log messages",
    do=(
        'write output="screen" into the <{xml}> to see it, or log it with self.get_logger().info(...)',
        'write `output: "screen"` below the exec of the {yaml} to see it, or log it with self.get_logger().info(...)',
        "set output='screen' on the Node to see it, or log it with self.get_logger().info(...)",
    ),
    lesson='01_first_launch',
    level='info',
    confidence='asked',
)
def output_hidden(recording: Recording) -> Iterator[Finding]:
    """Report nodes of a launch whose output and log messages appear nowhere. A node with a window does not count."""
    launched = {process.name: process for process in recording.processes if process.origin is not None and process.package}
    first: dict[str, str] = {}
    shown: list[str] = []
    for output in recording.output:
        name = output.process
        if name not in launched:
            shown.append(output.text)
        elif output.stream == 'stdout':
            first.setdefault(name, output.text.partition('\n')[0])
    console = ''.join(shown) if first else ''
    for name, line in first.items():
        is_windowed = os.path.basename(launched[name].argv[0]) in TERMINALS
        if line.strip() and f'[{name}] ' not in console and not is_windowed:
            file, line_number = launched[name].origin or (None, None)
            ending = os.path.splitext(file or '')[1]
            xml, yaml = ('node' if ending == form else None for form in ('.xml', '.yaml'))
            yield found('process', name, file=file, line=line_number, text=line[:40], xml=xml, yaml=yaml)
