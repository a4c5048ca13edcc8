"""What a program printed and no screen showed."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule

if TYPE_CHECKING:
    from edulaunch.recording import Recording

TERMINALS = ('gnome-terminal', 'konsole', 'xterm', 'x-terminal-emulator')


@rule(
    'launch.output-hidden',
    what='{process} prints "{text}", and the screen does not show it',
    why="a Node has output='log' unless it says otherwise; only what it logs is seen",
    do="give the Node output='screen', if you want to see it, or log it: self.get_logger().info(...)",
    lesson='01_first_launch',
    level='info',
    confidence='asked',
)
def output_hidden(recording: Recording) -> Iterator[Finding]:
    """Of nodes that launch has started, and of which nothing at all is seen: neither printed nor logged. Not of one that has a
    window of its own.
    """
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
            yield found('process', name, file=file, line=line_number, text=line[:40])
