"""Create rules for errors that carry facts (`edulaunch.engine.facts`)."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import Any

from edulaunch.advice.rule import Failure, Finding, Rule, Sentence, rule


def about(
    name: str, *, what: Sentence, do: Sentence, types: tuple[str, ...] = (), texts: tuple[str, ...] = (), **options: Any
) -> Rule:
    """Return the rule for errors whose fact `about` is `name`. The sentences of the rule use the facts of the error.

    :param name: the name of the rule.
    :param what: the sentence about the mistake, or several templates of it.
    :param do: the sentence about what to do, or several templates of it.
    :param types: names of error classes that this rule always explains.
    :param texts: error messages that this rule always explains.
    :param options: further arguments of :func:`edulaunch.advice.rule.rule`.
    """

    def look(failure: Failure) -> Iterator[Finding]:
        if failure.facts.get('about') == name or failure.type in types or failure.message in texts:
            yield report(failure)

    return rule(name, what=what, do=do, **{'level': 'error', **options})(look)


def in_share(text: str) -> str:
    """Return a message in which paths of a simulated build begin with `share` or `lib`, without the folder of the build."""
    return re.sub(r'\S*/edulaunch-[^/\s]+/[^/]+/(?=(?:share|lib)/)', '', text)


def report(failure: Failure, **facts: Any) -> Finding:
    """Return a finding about an error, with the facts of the error and the facts that the rule adds."""
    kind, name = ('process', failure.process) if failure.process else ('file', os.path.basename(failure.file or ''))
    return Finding(kind, name or '', {**failure.facts, **facts}, failure.file, failure.line, failure.time_s)
