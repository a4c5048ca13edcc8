"""edulaunch: learn ROS 2 launch, tf2 and turtlesim without ROS.

Runs unmodified launch files and rclpy packages in a deterministic simulation::

    import edulaunch
    recording = edulaunch.run('solutions/circle.launch.py', arguments={'circle_radius': '1.0'}, duration_s=20)
    recording.plot_turtles()

Importing this package loads nothing else and changes nothing; each name is loaded when it is first used.
"""

from __future__ import annotations

from edulaunch.engine import outside
from edulaunch.runtime import ros2_command
from edulaunch.runtime.version import __version__ as __version__

TYPE_CHECKING = False  # as `typing.TYPE_CHECKING`, without loading `typing`
if TYPE_CHECKING:
    from typing import Any

    from edulaunch.advice.explaining import explain
    from edulaunch.desk.machine.started import start
    from edulaunch.engine.recording import Recording
    from edulaunch.errors import EdulaunchError, LaunchFileError, UnusableInput
    from edulaunch.jupyter.checking import check
    from edulaunch.jupyter.interact import interact
    from edulaunch.ros.sourcing import source
    from edulaunch.runtime.session import Session, run

__all__ = [
    'EdulaunchError',
    'LaunchFileError',
    'Recording',
    'Session',
    'UnusableInput',
    'check',
    'explain',
    'interact',
    'run',
    'source',
    'start',
]

_PLACES = {
    'EdulaunchError': ('errors', 'EdulaunchError'),
    'LaunchFileError': ('errors', 'LaunchFileError'),
    'Recording': ('engine.recording', 'Recording'),
    'Session': ('runtime.session', 'Session'),
    'UnusableInput': ('errors', 'UnusableInput'),
    'check': ('jupyter.checking', 'check'),
    'explain': ('advice.explaining', 'explain'),
    'interact': ('jupyter.interact', 'interact'),
    'run': ('runtime.session', 'run'),
    'source': ('ros.sourcing', 'source'),
    'start': ('desk.machine.started', 'start'),
}


def _load_view(name: str) -> None:
    """Import the wing that registers a view of recordings."""
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
        import edulaunch.advice.rendering  # noqa: F401  # what is imported here registers itself


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
    place = _PLACES.get(name)
    if place is None:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    from importlib import import_module  # imported here, because it takes a third of the time of `import edulaunch`

    return getattr(import_module(f'{__name__}.{place[0]}'), place[1])


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
