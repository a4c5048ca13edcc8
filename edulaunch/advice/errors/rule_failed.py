"""A rule itself failed; the judge yields this finding."""

from __future__ import annotations

from collections.abc import Iterator

from edulaunch.advice.failure import Failure
from edulaunch.advice.finding import Finding
from edulaunch.advice.rule import rule


@rule(
    'programs.rule-failed',
    what="a rule of edulaunch, '{rule}', could not look at this: {error}",
    do='tell the makers of edulaunch, with your file: it is their mistake, and the rest of the advice holds',
    level='info',
)
def rule_failed(failure: Failure) -> Iterator[Finding]:
    """Nothing that a student writes looks like this."""
    yield from ()
