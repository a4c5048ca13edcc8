"""Faults of the computer: a full disk, no memory, no processes or descriptors left. Such faults never cost marks.

After an error that could be such a fault, the grader repeats the run. If the error occurs again, the grader tests the
computer. If the computer passes this test, the run caused the error.
"""

from __future__ import annotations

import errno
import json
import mmap
import os
import re
from contextlib import suppress
from importlib.util import find_spec
from typing import TYPE_CHECKING

from edulaunch.errors import how_to_install
from edulaunch.runtime.quiet_start import LOADING_FAULTS

from .sandbox.allowance import MOST_BYTES, MOST_BYTES_OF_FILE, MOST_FILES

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

    from .evidence import Outcome

SENTENCES = {
    errno.ENOSPC: 'the disk is full',
    errno.EDQUOT: 'the quota of the disk is used up',
    errno.EROFS: 'the directory for temporary files is not writable',
    errno.EIO: 'a disk of this computer does not work',
    errno.ENOMEM: 'this computer has no memory left',
    errno.EMFILE: 'this process has no descriptors left',
    errno.ENFILE: 'this computer has no descriptors left',
    errno.EAGAIN: 'this computer has no processes left',
    errno.ENOENT: 'the directory for temporary files does not exist',
    errno.EACCES: 'the directory for temporary files is not writable',
}
OF_THE_COMPUTER = frozenset(SENTENCES) - {errno.ENOENT, errno.EACCES}
"""Errors that a launch file usually cannot cause."""
REPORT_IT = 'report this with the launch file and the --json report; it costs no marks'
REPAIR = 'free disk space, memory or processes (see df, free and ulimit -a), and grade again; a batch continues with --resume'
_NUMBER = re.compile(r'\[Errno (\d{1,3})\]')
_LONGEST_LOOK = 200_000
_NO_FOLDER = 'No usable temporary directory'
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
"""Errors of a run that has written as much as it may, unless the disk of the computer is full."""
WRITE_LESS = f'write at most {MOST_BYTES >> 20} MiB, {MOST_FILES} files, and {MOST_BYTES_OF_FILE >> 20} MiB to one file in a run'
TRIED_BYTES, TRIED_MEMORY, TRIED_DESCRIPTORS = 1 << 18, 64 << 20, 24


EXTRAS = {
    'ros2 bag': ('rosbags', 'rosbags', 'bags'),
    'robot_state_publisher': ('urdf_parser_py', 'urdf-parser-py', 'urdf'),
    'joint_state_publisher': ('urdf_parser_py', 'urdf-parser-py', 'urdf'),
    'xacro': ('xacro', 'xacro', 'urdf'),
}
"""Programs that need a package of an extra: its module, its name, the extra."""


class ComputerFault(Exception):
    """This computer cannot grade now. The message is a sentence without a full stop."""


def missing_for(recording: Recording) -> tuple[str, str] | None:
    """Return the program and the missing Python package as a sentence, and how to install the package.

    Return None if no program of the run lacks a package.
    """
    for process in recording.processes:
        words = [os.path.basename(process.argv[0]), *process.argv[1:2]] if process.argv else []
        for name in (' '.join(words), *words[:1], process.executable or ''):
            module, package, extra = EXTRAS.get(name, ('', '', ''))
            if module and find_spec(module) is None:
                return f'{name} needs {package}, which is not installed', how_to_install(extra)
    return None


def fault_of(error: BaseException) -> str | None:
    """Return a sentence about the fault of the computer that caused an error, or None for any other error."""
    if isinstance(error, MemoryError):
        return SENTENCES[errno.ENOMEM]
    if isinstance(error, OSError) and error.errno in OF_THE_COMPUTER:
        return SENTENCES[error.errno] + (f': {error.filename}' if isinstance(error.filename, str) else '')
    return None


def raise_fault(error: BaseException) -> None:
    """Raise ComputerFault if a fault of the computer caused an error. Otherwise, do nothing.

    :raises ComputerFault: if a fault of the computer caused the error.
    """
    fault = fault_of(error)
    if fault is not None:
        raise ComputerFault(fault) from None


def fault_in(text: str) -> str | None:
    """Return a sentence about the fault of the computer whose error number is in a message, or None if the message contains no
    such number.
    """
    numbers = [int(number) for number in _NUMBER.findall(text)]
    return next((SENTENCES[number] for number in numbers if number in OF_THE_COMPUTER), None)


def advice_on_limits(text: str) -> str | None:
    """Return what to do about a message that says that a run wrote more than it may, or None for another message."""
    return WRITE_LESS if any(int(number) in FULL for number in _NUMBER.findall(text)) else None


def looks_like_one(outcome: Outcome) -> bool:
    """Return whether a fault of the computer, such as a full disk, may have caused an outcome.

    The function searches the outcome for error numbers and messages of such faults.
    """
    text = _text_of(outcome)
    return fault_in(text) is not None or any(words in text for words in (*LOADING_FAULTS, 'MemoryError', _NO_FOLDER))


def _text_of(outcome: Outcome) -> str:
    texts = [outcome.text, outcome.detail]
    if outcome.recording is not None:
        with suppress(Exception):  # a hostile recording can make the reader raise any exception
            programs = outcome.recording.processes
            texts += [json.dumps(program.exception, default=str) for program in programs if program.exception is not None]
            # launch's message names the program that it could not start, and the error
            texts += [log.message for log in outcome.recording.logs if log.process == 'launch' and log.level >= 40]
    return '\n'.join(text for text in texts if isinstance(text, str))[:_LONGEST_LOOK]


def fault_here(folder: str) -> str | None:
    """Test everything that a run needs on this computer. Return a sentence about the first thing that does not work, or None if
    everything works.

    :param folder: the directory for the test.
    """
    path = os.path.join(folder, f'.tried-{os.urandom(4).hex()}')
    opened: list[int] = []
    try:
        try:
            opened.append(os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600))
            if os.write(opened[0], bytes(TRIED_BYTES)) < TRIED_BYTES:
                return SENTENCES[errno.ENOSPC]
            os.fsync(opened[0])
            opened += [os.dup(opened[0]) for _ in range(TRIED_DESCRIPTORS)]
            mmap.mmap(-1, TRIED_MEMORY).close()
            pid = os.fork()
            if pid == 0:
                os._exit(0)
            os.waitpid(pid, 0)
        finally:
            for descriptor in opened:
                os.close(descriptor)
            with suppress(OSError):
                os.unlink(path)
    except OSError as error:
        return SENTENCES.get(error.errno or 0, f'this computer cannot run a submission: {error.strerror}')
    return None


def killed_for_memory() -> int:
    """Return the number of processes that the system has killed because the memory was full. Without such a count, return 0."""
    with suppress(OSError, ValueError, StopIteration), open('/proc/vmstat') as file:
        return next(int(line.split()[1]) for line in file if line.startswith('oom_kill '))
    return 0


def no_mark_for(outcome: Outcome, fault: str) -> Outcome:
    """Return an outcome without a mark for a run that a fault of the computer has ended.

    :param fault: a sentence about the fault.
    """
    return outcome._replace(
        kind='broke', recording=None, text=f'not graded: {fault}', try_=REPAIR, where=None, detail=outcome.text
    )


def words_of(error: Exception) -> tuple[str, str]:
    """Return why a submission was not graded, and what to do. The student did not cause the error."""
    fault = str(error) if isinstance(error, ComputerFault) else fault_of(error)
    if fault is not None:
        return f'not graded: {fault}', REPAIR
    return f'the grader broke: {type(error).__name__}: {error}', REPORT_IT
