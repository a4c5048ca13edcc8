"""The line below an error: what is wrong with it, and what to do."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from edulaunch.advice.failure import Failure
from edulaunch.advice.judging import judge_failure
from edulaunch.advice.reader import Reader, reader_of
from edulaunch.advice.wording import told


def help_below(error: dict[str, Any], env: Mapping[str, str]) -> str | None:
    """One line about an error, None when nothing is known of it.

    :param error: `type`, `message`, `facts` and `place`; and `process`, the program that it ended. Without that it is an error of
        a launch file, whose place is told too: nothing above says it.
    :param env: of the program in whose terminal it is read.
    """
    file, line = error.get('place') or (None, None)
    failure = Failure(error['type'], error['message'], file, line, None, error.get('process'), error['facts'])
    words = help_text(failure, reader_of(env, ''))
    if failure.process is not None or file is None:
        return words
    action = failure.facts.get('action')
    where = f'{file}:{line}{f" ({action})" if action else ""}'
    return where if words is None else f'{where}: {words}'


def help_of(error: dict[str, Any]) -> str | None:
    """What is wrong and what to do, in one line, about an error as data, in the language of who started this program."""
    file, line = error.get('place') or (None, None)
    return help_text(Failure(error['type'], error['message'], file, line, facts=error['facts']))


def help_of_facts(facts: dict[str, Any]) -> str:
    """What is wrong and what to do, in one line, by facts alone; '' when there are none."""
    return help_text(Failure('', '', facts=facts)) or ''


def help_text(failure: Failure, reader: Reader | None = None) -> str | None:
    """What is wrong and what to do, in one line; None when no rule knows the error."""
    found = judge_failure(failure)
    if not found:
        return None
    words = told(found[0], reader)
    return '; '.join(filter(None, (words.what, words.do)))
