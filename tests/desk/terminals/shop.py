"""Bash in real terminals, with the commands of an environment that has edulaunch, and a machine whose time goes fast."""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

from tests.desk.machine.shells import Desk, Shell
from tests.desk.terminals.pages import Page, Step

COMMANDS = {'ros2': 'desk.machine.command:ros2', 'rosdep': 'desk.cli.rosdep:command', 'edulaunch': 'desk.cli.main:main'}
SPEED = 10
PROMPT = re.compile(r'<(\d+)>\$ $')
ESCAPES = re.compile(r'\x1b\[[0-9;?]*[A-Za-z]|\r')
SEEDS = Path(__file__).resolve().parents[3].parent / 'shared' / 'seeds' / 'files'


class Terminal:
    """One bash."""

    def __init__(self, shell: Shell) -> None:
        self._shell = shell
        self._seen = 0
        self.busy: Step | None = None
        self.wait()

    @property
    def new(self) -> str:
        """What was written since the command was typed."""
        return ESCAPES.sub('', self._shell.output[self._seen :])

    def wait(self) -> int:
        """Wait for the prompt; returns the exit code of the last command."""
        self._shell.until(lambda output: PROMPT.search(ESCAPES.sub('', output)))
        self.busy = None
        found = PROMPT.search(ESCAPES.sub('', self._shell.output))
        assert found is not None
        return int(found[1])

    def type(self, line: str) -> None:
        """Type a line."""
        self._seen = len(self._shell.output)
        self._shell.type(line + '\n')
        self._shell.until(lambda output: line[-20:] in ESCAPES.sub('', output[self._seen :]) or len(line) > 60)
        self._shell.until(lambda output: '\n' in output[self._seen :])

    def expect(self, patterns: tuple[str, ...]) -> None:
        """Read until the patterns have come, in this order."""
        for count in range(1, len(patterns) + 1):
            whole = re.compile('(?s)' + '.*?'.join(f'(?m:{pattern})' for pattern in patterns[:count]))
            self._shell.until(lambda output, whole=whole: whole.search(ESCAPES.sub('', output[self._seen :])))

    def press(self, keys: str) -> None:
        """Press keys; what was there before is not looked at any more."""
        self._seen = len(self._shell.output)
        self._shell.type(keys)


class Shop:
    """As many terminals as a page opens."""

    def __init__(self, folder: Path, page: Page) -> None:
        self.home = folder / 'home'
        for place in (self.home, folder / 'run', folder / 'bin'):
            place.mkdir()
        for name, entry in COMMANDS.items():
            module, function = entry.split(':')
            script = folder / 'bin' / name
            script.write_text(
                f'#!{sys.executable}\nimport sys\nfrom edulaunch.{module} import {function}\nsys.exit({function}())\n'
            )
            script.chmod(0o755)
        wget = folder / 'bin' / 'wget'  # no test asks a network: what the page has on the web lies in web/
        wget.write_text('#!/bin/sh\ncp "$HOME/web/${1##*/}" .\n')
        wget.chmod(0o755)
        self.desk = Desk(folder / 'run', self.home)
        del self.desk.env['ROS_HOME']  # log files are where a tutorial looks for them
        self.desk.env.update(
            HOME=str(self.home),
            PATH=os.pathsep.join([str(folder / 'bin'), os.environ['PATH']]),
            PS1='<$?>$ ',
            TERM='dumb',
            INPUTRC=os.devnull,
            USER='student',
            EDULAUNCH_TURN_LIMIT_S='5',
        )
        self.terminals: dict[int, Terminal] = {}
        self._keep_time()
        self._lay_out(page)

    def _keep_time(self) -> None:
        """The machine stays between the commands, and its time goes fast."""
        self.desk.ros2('multicast receive').until('Waiting')
        words = ['-c', 'import sys; from edulaunch.desk.cli.main import main; sys.exit(main())']
        speed = Shell('machine', 'speed', str(SPEED), cwd=self.home, env=self.desk.env, program=[sys.executable, *words])
        self.desk.shells.append(speed)
        assert speed.end() == 0, speed.output

    def _lay_out(self, page: Page) -> None:
        import shutil

        for source, target in page.copies:
            place = self.home / target
            place.parent.mkdir(parents=True, exist_ok=True)
            whole = SEEDS / source
            if whole.is_dir():
                shutil.copytree(whole, place, dirs_exist_ok=True)
            else:
                shutil.copy(whole, place)
        for name, text in page.files:
            (self.home / name).parent.mkdir(parents=True, exist_ok=True)
            (self.home / name).write_text(text, encoding='utf-8')

    def terminal(self, number: int) -> Terminal:
        """The terminal of that number; a new one has what a student has set up once."""
        if number not in self.terminals:
            shell = Shell('--norc', '--noprofile', '-i', cwd=self.home, env=self.desk.env, program=['/bin/bash'])
            self.desk.shells.append(shell)
            self.terminals[number] = Terminal(shell)
            self.terminals[number].type('eval "$(edulaunch env --shell)"')
            self.terminals[number].wait()
        return self.terminals[number]

    def do(self, step: Step) -> None:
        """Type a step and look at what it shows."""
        terminal = self.terminal(step.terminal)
        if terminal.busy is not None:
            terminal.press('\x03')
            terminal.wait()
        terminal.type(step.typed)
        terminal.expect(step.shows)
        terminal.busy = step if step.runs else None
        if step.keys:
            terminal.press(step.keys.encode().decode('unicode_escape'))
            terminal.expect(step.then)
        if not step.runs or step.stop:
            if step.stop:
                terminal.press('\x03')
            code = terminal.wait()
            assert step.stop or code == step.code, f'{step.typed}: exit code {code}: {terminal.new}'
