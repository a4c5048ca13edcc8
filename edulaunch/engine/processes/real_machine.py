"""Records which simulated programs read facts of the real machine. Such a run cannot repeat exactly, and its recording states
this.

The module uses Python's own audit events, which also occur inside libraries (`psutil` reads `/proc`, `requests` connects). A few
modules and functions reveal facts about the machine without such an event. Their use by the student's code is recorded. Importing
a library that inspects the machine does not count, because the result seldom matters. Views cannot replace the audit hook: they
only affect the student's own code, and installed libraries do not use them. The module also lists the folders of this machine
that must not change a digest.
"""

from __future__ import annotations

import os
import site
import sys
import sysconfig
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from types import FrameType
from typing import Any, Protocol

from edulaunch.engine.processes.frame_owner import is_library, is_own
from edulaunch.engine.sim.task import AmbientTask, running_task

KIND = 'real machine'
"""The kind of the note."""
MODULES = frozenset({'cpuinfo', 'getmac', 'netifaces', 'platform', 'psutil', 'pwd', 'resource', 'GPUtil', 'pynvml'})
"""Modules whose import counts as reading the machine."""
FUNCTIONS = ('getloadavg', 'getlogin', 'getresuid', 'getuid', 'sched_getaffinity', 'statvfs', 'times', 'umask', 'uname')
"""Functions of `os` that reveal facts about the machine."""
FOLDERS = ('/proc/', '/sys/', '/dev/')
REPEATS = frozenset({'/dev/null', '/dev/full', '/dev/zero', '/dev/stdin', '/dev/stdout', '/dev/stderr', '/dev/tty'})
SOCKETS = tuple(f'socket.{name}' for name in ('bind', 'connect', 'getaddrinfo', 'gethostbyname', 'gethostname', 'sendto'))
FILES = frozenset({'open', 'os.listdir', 'os.scandir'})
PROGRAMS = frozenset({'subprocess.Popen', 'os.system', 'os.posix_spawn', 'os.fork', 'os.exec'})
VIEWS = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'module_views', '')
TEMPORARY = frozenset({'tempfile.mkdtemp', 'tempfile.mkstemp'})
EVENTS = frozenset({*SOCKETS, *FILES, *PROGRAMS, *TEMPORARY, 'builtins.id'})
FindLines = Callable[[bytes], Sequence[int]]
_listening = False


def listen() -> None:
    """Install the audit hook, unless it is installed already. Python cannot remove the hook.

    While no simulated program runs, the hook records nothing.
    """
    global _listening
    if not _listening:
        _listening = True
        sys.addaudithook(_hear)


PERSONAL = frozenset({'USER', 'LOGNAME', 'HOSTNAME'})
"""Environment variables whose value differs for each person or computer."""


class Environment(dict[str, str]):
    """The environment of a program. Each read of one of the :data:`PERSONAL` variables is recorded.

    :param process: the program.
    :param values: the initial variables.
    """

    def __init__(self, process: Noting, values: Mapping[str, str]) -> None:
        super().__init__(values)
        self._process = process

    def __getitem__(self, name: str) -> str:
        if name in PERSONAL and name in self:
            note_use(self._process, f'${name}')
        return super().__getitem__(name)

    def get(self, name: str, default: Any = None) -> Any:
        """Return the value of a variable, or `default`, like `dict.get`."""
        try:
            return self[name]
        except KeyError:
            return default


class Noting(Protocol):
    """A program whose use of the real machine is recorded."""

    used: set[str]

    @property
    def name(self) -> str: ...

    def note(self, kind: str, text: str) -> None: ...


def note_use(process: Noting, what: str) -> None:
    """Record that a program has used a part of the real machine. Each part is recorded once.

    :param what: the part, in words that follow 'used'.
    """
    text = f'{process.name} used {what}: this run cannot repeat exactly'
    if text not in process.used:
        process.used.add(text)
        process.note(KIND, text)


def noting(process: Noting, what: str, function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a wrapper of a function that records calls by the student's own code.

    :param what: the name of the function for the record.
    """

    def call(*arguments: Any, **options: Any) -> Any:
        if _library_between(VIEWS) is not None:
            note_use(process, what)
        return function(*arguments, **options)

    return call


def has_random_hashes() -> bool:
    """Return whether hashes of strings, and so the order of a set of strings, differ from run to run of Python."""
    return bool(sys.flags.hash_randomization) and os.environ.get('PYTHONHASHSEED', 'random') == 'random'


def private_hash(process: Noting) -> Callable[[object], int]:
    """Return a `hash` that records calls for values whose hash differs from run to run. Calls from a `__hash__` are not
    recorded.
    """
    random_types = (str, bytes) if has_random_hashes() else ()

    def differs(value: object) -> bool:
        if isinstance(value, (tuple, frozenset)):
            return any(map(differs, value))
        return isinstance(value, random_types) or (type(value).__hash__ is object.__hash__)

    def call(value: object, /) -> int:
        if sys._getframe(1).f_code.co_name != '__hash__' and differs(value):  # dictionaries have the order of their insertions
            note_use(process, 'hash()')
        return hash(value)

    return call


def note_set_order(process: Noting, file: str, find_lines: FindLines) -> None:
    """Record the first line of a student's file that uses the order of a set, if this order differs from run to run.

    :param find_lines: a function that returns the lines of a source that use such an order.
    """
    if file.endswith('.py') and has_random_hashes() and is_own(file):
        lines: Sequence[int] = ()
        with suppress(OSError, SyntaxError), open(file, 'rb') as source:  # the file may have changed in the meantime
            lines = find_lines(source.read())
        if lines:
            note_use(process, f'the order of a set (PYTHONHASHSEED is not set) in {os.path.basename(file)}:{lines[0]}')


def _hear(event: str, arguments: tuple[Any, ...]) -> None:
    if event not in EVENTS:
        return
    what = event
    if event in FILES:
        what = arguments[0]
        if not isinstance(what, str) or not what.startswith(FOLDERS) or what in REPEATS:
            return
    task = running_task()
    if task is None or isinstance(task, AmbientTask) or getattr(task.owner, 'tracer', None) is None:
        return
    if event in TEMPORARY:
        task.owner.tracer.temporary(arguments[0])
        return
    library = _library_between('' if event in PROGRAMS else VIEWS)  # the view of `subprocess` records real programs itself
    if library is not None and not (library and event == 'builtins.id'):  # such numbers inside a library seldom matter
        note_use(task.owner, f'{what} ({library})' if library else what)


def _library_between(views: str) -> str | None:
    """Return the library between the student's code and this call, '' for a direct call, or None if other code made the call.

    :param views: a folder with modules that only forward calls, or ''.
    """
    frame: FrameType | None = sys._getframe(2)
    library = ''
    while frame is not None:
        file = frame.f_code.co_filename
        if is_own(file):
            return library
        if is_library(file):
            library = frame.f_globals.get('__name__', '').partition('.')[0]
        elif not views or not file.startswith(views):
            return None
        frame = frame.f_back
    return None


SYSTEM = frozenset({'', '/', '/usr', '/usr/local', '/home', '/opt'})
"""Folders that are left out, because their content differs on every machine."""


def machine_roots() -> list[list[str]]:
    """Return pairs (folder, short name), the more specific folders first.

    If two names belong to the same folder, the first name is used.
    """
    import tempfile  # imported here, because only a recording needs it

    packages = [sysconfig.get_path('purelib'), sysconfig.get_path('platlib'), site.getusersitepackages()]
    found = [
        (sys.executable, '@sys.executable'),
        (tempfile.gettempdir(), '@tmp'),
        (os.path.dirname(os.__file__), '@stdlib'),
        *((folder, '@site-packages') for folder in packages if folder),  # a browser has no user folder
        (sys.prefix, '@sys.prefix'),
        (sys.base_prefix, '@sys.base_prefix'),
    ]
    with suppress(FileNotFoundError):  # the folder was removed in the meantime
        found.append((os.getcwd(), '@cwd'))
    return [*with_real_paths(found), *with_real_paths([(os.path.expanduser('~'), '@home')])]


def with_real_paths(roots: Iterable[tuple[str, str]]) -> Iterator[list[str]]:
    """Yield each root, followed by its real path without links if this differs. Folders of the system are left out."""
    for path, name in roots:
        for place in dict.fromkeys((path, os.path.realpath(path))):
            if place not in SYSTEM:
                yield [place, name]
