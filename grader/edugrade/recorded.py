"""Takes a recording from the bytes that a child sent, and looks whether launch came to its end."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from .outcome import Outcome
from .place import Place, is_engine
from .scenario import Scenario

if TYPE_CHECKING:
    from edulaunch.recording import Recording
    from edulaunch.recording.records import LaunchRecord

_LOOK = 'look at this line, and at the one before it'
_LOOP = 'look for a loop that does not end: a launch file only says what to start'
_STARTS_NOTHING = 'return a LaunchDescription with a Node in it; take out calls of os._exit() and sys.exit()'


def recorded(scenario: Scenario, content: bytes) -> Outcome | None:
    """The outcome that these bytes stand for; None when they are no recording of this scenario.

    :param content: a line of JSON, which nodes and parameters are the trusted half's own; then the recording.
    """
    from edulaunch.recording import Recording as Known

    try:
        hosted, _, rest = content.partition(b'\n')
        recording = Known.from_bytes(rest)
        recording.hosted_nodes, recording.hosted_parameters = map(frozenset, json.loads(hosted))
        if recording.seed != scenario.seed or recording.launch.arguments != dict(scenario.arguments):
            return None
    except Exception:  # hostile bytes may upset the reader in any way; each of them means the same
        return None
    return come_to(scenario, recording)


def come_to(scenario: Scenario, recording: Recording) -> Outcome:
    """The outcome of a run that was recorded: whether launch came to its end."""
    launch, programs = recording.launch, recording.processes
    if launch.error is not None:
        return _launch_error(scenario, launch)
    stuck = programs[0].exception if programs else None
    if stuck is not None and stuck['type'] == 'RunawayProgramError':
        place = Place(stuck['file'], stuck['line']) if stuck.get('file') else None
        return Outcome(scenario, 'stopped', text='the launch file never came to its end and was stopped', try_=_LOOP, where=place)
    if launch.returncode is not None and len(programs) <= 1:
        text = f'launch ended with exit code {launch.returncode} and had started nothing'
        return Outcome(scenario, 'stopped', text=text, try_=_STARTS_NOTHING)
    return Outcome(scenario, 'recorded', recording=recording)


def _launch_error(scenario: Scenario, launch: LaunchRecord) -> Outcome:
    """Launch's own text, without its last line, which is the place again."""
    text = (launch.error or '').removesuffix(f'\n  at {launch.error_file}:{launch.error_line}')
    where = None
    if launch.error_file is not None and not is_engine(launch.error_file):
        where = Place(launch.error_file, launch.error_line)
    return Outcome(scenario, 'unusable', text=text, try_=launch.help or _LOOK, where=where)
