"""What was handed to `publish()` or to a field has another type."""

from __future__ import annotations

import re
from collections.abc import Iterator

from edulaunch.advice.failure import Failure
from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule

_SAID = re.compile(r"Expected <class '(?P<module>[\w.]+)\.(?P<wanted>\w+)'>, got <class '(?:[\w.]+\.)?(?P<got>\w+)'>")


@rule(
    'messages.published-no-message',
    what='publish() was given a {got}, but this publisher sends {wanted} messages',
    why='a topic carries messages of one type; Python does not turn a {got} into one',
    do='make a message, set its fields, and publish that: msg = {wanted}(), then publisher.publish(msg)',
    level='error',
)
def published_no_message(failure: Failure) -> Iterator[Finding]:
    """rclpy's own TypeError names both classes."""
    said = _SAID.search(failure.message) if failure.type == 'TypeError' else None
    if said is not None:
        yield found(
            'process', failure.process or '', file=failure.file, line=failure.line, time_s=failure.time_s, **said.groupdict()
        )
