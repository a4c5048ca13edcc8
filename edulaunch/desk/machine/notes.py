"""Notes that a terminal prints about programs that behave differently on a real computer, because of a window or a keyboard."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process

VIEWS = {'turtlesim_node': 'graph', 'rviz2': 'frames', 'waffle_simulator': 'graph', 'joint_state_publisher_gui': 'frames'}
"""Programs with a window on a real computer, and the tab of the live view with the same content."""
READ_KEYS = {
    'turtle_teleop_key': 'turtlesim',
    'teleop_twist_keyboard': 'teleop_twist_keyboard',
    'teleop_keyboard': 'turtlebot3_teleop',
}
"""Programs that read keys, and their packages."""


class Notes:
    """Decides which notes a machine's terminals print. Each note is printed once.

    :ivar knows_view: whether the user has a live view, or has seen the note about it.
    """

    def __init__(self) -> None:
        self.knows_view = False
        self._reported_pids: set[int] = set()
        self._reported_packages: set[tuple[int, str]] = set()

    def about(self, words: Sequence[str], programs: Sequence[Process]) -> Iterator[str]:
        """Yield the notes that a terminal should print now.

        :param words: the command of the terminal.
        :param programs: the programs that run in the terminal, the command first.
        """
        if not programs:
            return
        yield from self.same_names(words, programs)
        is_there = len(words) > 3 and words[2] in programs[0].index.packages()
        names = [*(words[3:4] if is_there else []), *(each.spec.executable or '' for each in programs)]
        if not self.knows_view:
            for name in filter(VIEWS.__contains__, names):
                self.knows_view = True
                yield f'note: {name} opens no window here; `edulaunch view --tab {VIEWS[name]}` shows it in a browser\n'
                break
        if words[:2] == ['ros2', 'launch'] and programs[0].pid not in self._reported_pids:
            for name in filter(READ_KEYS.__contains__, names):
                self._reported_pids.add(programs[0].pid)
                yield (
                    f'note: {name} cannot read keys when a launch file starts it; '
                    f'type `ros2 run {READ_KEYS[name]} {name}` in another terminal\n'
                )
                break

    def same_names(self, words: Sequence[str], programs: Sequence[Process]) -> Iterator[str]:
        """Yield a note for each package that several folders contain.

        The note names the package that is used, which is nearest to the terminal.
        """
        command = programs[0]
        packages = [
            *(words[2:3] if words[:2] in (['ros2', 'run'], ['ros2', 'launch']) else []),
            *(each.spec.package for each in programs),
        ]
        for package in filter(None, dict.fromkeys(packages)):
            used = command.index.source_folder(package)
            here = [one.file for one in command.index.warnings if one.about == 'same name' and f'{package!r} in' in one.sentence]
            if used is not None and here and (command.pid, package) not in self._reported_packages:
                self._reported_packages.add((command.pid, package))
                left = ', '.join(os.path.relpath(os.path.dirname(file), command.spec.cwd) for file in here)
                used = os.path.relpath(used, command.spec.cwd)
                yield f'note: several packages have the name {package}; this command uses {used}, not {left}\n'
