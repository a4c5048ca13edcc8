"""What `ros2 doctor` says of a machine besides ROS 2's own checks. It is no part of what the command printed inside the
simulation: a recording has no sentence in anybody's language.
"""

from __future__ import annotations

from collections.abc import Sequence

from edulaunch.advice.diagnosis import diagnosis
from edulaunch.advice.reader import Reader
from edulaunch.machine.snapshot import glance
from edulaunch.session import Session


def is_doctor(words: Sequence[str]) -> bool:
    """Whether a command asks for the checks, and not for a report of what there is."""
    return (
        len(words) > 1 and words[0] == 'ros2' and words[1] in ('doctor', 'wtf') and not {'hello', '-r', '--report'} & set(words)
    )


def doctors_text(session: Session, reader: Reader) -> str:
    """What the rules find in what ran on the machine until now."""
    heading = reader.says('edulaunch has looked at what ran here until now:')
    return '\n'.join((heading, *diagnosis(glance(session).advice, reader), ''))
