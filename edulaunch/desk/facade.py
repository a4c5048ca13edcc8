"""The public names of `import edulaunch`. Each name is loaded when it is first used.

`edulaunch/__init__.py` uses `__getattr__` and `__dir__` of this module. Every import of edulaunch loads this module, so it
imports little. This module also imports the parts of edulaunch that register the views of recordings.
"""

from __future__ import annotations

import sys

from edulaunch.engine import outside
from edulaunch.runtime import ros2_command

TYPE_CHECKING = False  # equals `typing.TYPE_CHECKING`, but does not load `typing`
if TYPE_CHECKING:
    from typing import Any

PLACES = {
    '__version__': ('runtime.version', '__version__'),
    'EdulaunchError': ('errors', 'EdulaunchError'),
    'LaunchFileError': ('errors', 'LaunchFileError'),
    'Recording': ('engine.recording', 'Recording'),
    'Session': ('runtime.session', 'Session'),
    'UnusableInput': ('errors', 'UnusableInput'),
    'check': ('desk.notebook.checking', 'check'),
    'explain': ('advice.explaining', 'explain'),
    'interact': ('desk.notebook.interact', 'interact'),
    'run': ('runtime.session', 'run'),
    'source': ('ros.sourcing', 'source'),
    'start': ('desk.machine.started', 'start'),
    'load_ipython_extension': ('desk.notebook', 'load_ipython_extension'),
}

__all__ = [name for name in PLACES if name not in ('__version__', 'load_ipython_extension')]


def _load_view(name: str) -> None:
    """Import the module that registers a view of recordings, such as `plot_turtles`."""
    if name in ('message_table', 'log_table'):
        import edulaunch.canvas.table
    elif name.startswith('plot_') or name == 'parameter_table':
        import edulaunch.canvas
    elif name == 'launch_trace':
        import edulaunch.advice.plan.launch_trace
    elif name == 'foxglove':
        from edulaunch.engine.recording.views import register
        from edulaunch.runtime.plugins import offered

        register(foxglove=offered('foxglove'))
    elif name == 'replay':
        import edulaunch.desk.view.replay
    else:
        import edulaunch.advice.rendering  # noqa: F401  # the imported modules register themselves


def _ros2(process: Any) -> Any:
    from edulaunch.desk.cli.ros2.commands import main

    return main(process)


def _ros2_words(words: Any, typed: str, index: Any, lines_of: Any) -> Any:
    from edulaunch.desk.cli.candidates import ros2_words

    return ros2_words(words, typed, index, lines_of)


def _process_of_a_script(task: Any) -> Any:
    from edulaunch.runtime.ambient import make_ambient_process

    return make_ambient_process(task)


outside.make_process = _process_of_a_script
ros2_command.run = _ros2
ros2_command.complete = _ros2_words
outside.load_view = _load_view


def __getattr__(name: str) -> Any:
    place = PLACES.get(name)
    if place is None:
        raise AttributeError(f"module 'edulaunch' has no attribute {name!r}")
    from importlib import import_module  # imported here, because it takes a third of the time of `import edulaunch`

    return getattr(import_module(f'edulaunch.{place[0]}'), place[1])


def __dir__() -> list[str]:
    return sorted({*vars(sys.modules['edulaunch']), *PLACES})
