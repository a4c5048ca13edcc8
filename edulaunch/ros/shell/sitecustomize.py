"""Makes `python3 node.py` work in a shell that has evaluated `edulaunch env --shell`, as in a shell that has sourced ROS 2.

Every Python of such a shell runs this file at its start. The file sources edulaunch at the first import of a ROS package, or of a
module that is not found otherwise. Python's own and installed modules often try names that do not exist (`copy` tries
`org.python.core`). For these names, no workspace is searched, because reading a workspace needs such modules.
"""

import os
import sys
from importlib.machinery import PathFinder

_HERE = os.path.dirname(os.path.abspath(__file__))
_UNDERLAY = os.path.dirname(_HERE)
_INSTALLED = tuple(folder + os.sep for folder in (os.path.dirname(os.__file__), sys.prefix, os.path.dirname(_UNDERLAY)))
_JOIN = 'import sys; from edulaunch.desk.machine.client import run; sys.exit(run(["python3", *sys.argv[1:]]))'


def _is_asked_by_installed():
    """Return whether the importing module belongs to Python, an installed package or edulaunch. Frames of the import machinery
    are skipped.
    """
    frame = sys._getframe(2)
    while frame is not None and frame.f_globals.get('__name__', '').partition('.')[0] in ('importlib', 'pkgutil', 'runpy'):
        frame = frame.f_back
    file = '' if frame is None else frame.f_code.co_filename
    return file.startswith(_INSTALLED) or '-packages' + os.sep in file


def _join_machine():
    """Run a program that a person has started in a terminal on the shared machine, instead of in this process.

    A debugger, an interactive Python, a test and a program that is read through a pipe do not join the machine.
    """
    main = os.path.abspath(getattr(sys.modules.get('__main__'), '__file__', None) or '')
    is_script = bool(sys.argv[0]) and os.path.isfile(main) and os.path.abspath(sys.argv[0]) == main
    is_alone = main.startswith(_INSTALLED) or '-packages' + os.sep in main or sys.flags.interactive or sys.gettrace() is not None
    if os.name == 'posix' and is_script and not is_alone and (os.isatty(1) or os.isatty(2)):
        sys.stdout.flush()
        os.execv(sys.executable, [sys.executable, '-c', _JOIN, *sys.argv])


class _Sourcing:
    """A finder at one end of `sys.meta_path` that sources edulaunch, but finds no module itself."""

    def __init__(self, names=None):
        self._names = names  # None, the value of the last finder, means all modules

    def find_spec(self, name, path=None, target=None):
        if path is not None or self._names is not None and name not in self._names:
            return None
        if self._names is None and _is_asked_by_installed():
            return None
        if self._names is not None:
            _join_machine()
        sys.meta_path[:] = [finder for finder in sys.meta_path if not isinstance(finder, _Sourcing)]
        try:
            from edulaunch.engine.packages.discovery import find_workspaces
            from edulaunch.ros.sourcing import source
        except ImportError:
            return None  # this is the Python of another environment
        workspaces = find_workspaces(os.getcwd(), os.environ, sys.argv[0] if os.path.isfile(sys.argv[0]) else None)
        if self._names is None and not workspaces:
            return None
        source(workspaces)
        specs = (finder.find_spec(name, None) for finder in list(sys.meta_path) if hasattr(finder, 'find_spec'))
        return next((spec for spec in specs if spec is not None), None)


_names = {name for folder in ('share', 'python') for name in os.listdir(os.path.join(_UNDERLAY, folder))}
sys.meta_path.insert(0, _Sourcing(_names))
sys.meta_path.append(_Sourcing())

_other = PathFinder.find_spec('sitecustomize', [path for path in sys.path if os.path.abspath(path) != _HERE])
if _other is not None and _other.loader is not None:  # run the sitecustomize that this file hides
    _other.loader.exec_module(sys.modules[__name__])
