"""Make `source .venv/bin/activate` set up edulaunch: commands, completion, import packages, and answers to set-up lines.

`edulaunch env --install` writes the shell code once, so that a new shell does not have to start Python. `bin/activate` reads
the written file, and `deactivate` undoes all changes.
"""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path
from shlex import quote

from edulaunch.desk.cli.completion import SCRIPTS, SHELLS
from edulaunch.engine.underlay_place import underlay_prefix, underlay_python
from edulaunch.errors import UnusableInput

WINDOWS = 'check_urdf gazebo gz rqt rqt_console rqt_graph rqt_plot rviz2'
START, END = '# >>> edulaunch >>>', '# <<< edulaunch <<<'
_BLOCK = re.compile(rf'\n?{START}\n.*?{END}\n', re.S)
HOOKS = {
    'activate': (
        'edulaunch.sh',
        'if [ -n "${BASH_VERSION:-}${ZSH_VERSION:-}" ] && [ -x "$VIRTUAL_ENV/bin/edulaunch" ]; then\n'
        '    . "$VIRTUAL_ENV/bin/edulaunch.sh"\n'
        'fi',
    ),
    'activate.fish': (
        'edulaunch.fish',
        'if test -x "$VIRTUAL_ENV/bin/edulaunch"\n    builtin source "$VIRTUAL_ENV/bin/edulaunch.fish"\nend',
    ),
}
"""For each script of the environment: the file that it reads, and the lines that read it."""


def install(prefix: Path) -> list[Path]:
    """Make the `activate` scripts of a virtual environment also set up edulaunch. A second call changes nothing.

    :param prefix: the folder of the virtual environment.
    :return: the paths of the scripts to source: one for bash and zsh, and one for fish if the environment has it.
    :raises UnusableInput: when the folder is not a virtual environment with a script `bin/activate`.
    """
    folder = prefix / 'bin'
    if not (folder / 'activate').is_file():
        raise UnusableInput(
            f'{prefix} is not a virtual environment with a script bin/activate',
            help='make one: python3 -m venv .venv, then .venv/bin/pip install the folder of edulaunch into it',
        )
    written = []
    for script, (name, lines) in HOOKS.items():
        path = folder / script
        if not path.is_file():
            continue
        (folder / name).write_text(lines_for(name), encoding='utf-8')
        before = path.read_text('utf-8')
        after = _BLOCK.sub('', before).rstrip('\n') + f'\n\n{START}\n{lines}\n{END}\n'
        if after != before:
            path.write_text(after, encoding='utf-8')
        written.append(path)
    return written


def lines_for(name: str) -> str:
    """Return the content of `edulaunch.sh` or `edulaunch.fish`.

    The values for this Python replace the @NAMES@ of the template.
    """
    names = f'colcon sudo apt source . ls {WINDOWS}'
    values = {
        'SHELL': quote(os.path.join(underlay_prefix(), 'shell')),
        'PYTHON': quote(underlay_python()),
        'PREFIX': quote(underlay_prefix()),
        'NAMES': names,
        'WINDOWS': WINDOWS,
        'FUNCTIONS': quote(functions()),
        'BASH': quote(SCRIPTS['bash']),
        'ZSH': quote(SCRIPTS['zsh']),
        'FISH': SCRIPTS['fish'],
    }
    return re.sub('@([A-Z]+)@', lambda found: values[found[1]], (SHELLS / name).read_text('utf-8'))


def functions() -> str:
    """Return shell functions for bash and zsh that explain the set-up commands of a tutorial, such as `colcon` and `sudo`."""
    return (SHELLS / 'answers.sh').read_text('utf-8').replace('@WINDOWS@', WINDOWS)


def install_here() -> list[Path]:
    """Call `install` for the virtual environment of this Python."""
    return install(Path(sys.prefix))
