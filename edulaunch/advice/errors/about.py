"""The sentences of rules for errors that carry facts (`edulaunch.engine.facts`)."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import Any

from edulaunch.advice.rule import Failure, Finding, Rule, Sentence, rule


def about(
    name: str, *, what: Sentence, do: Sentence, types: tuple[str, ...] = (), texts: tuple[str, ...] = (), **options: Any
) -> Rule:
    """Return the rule for errors about `name`. Its sentences use the facts of the error.

    :param types: classes of errors that are always about it.
    :param texts: messages that always mean this error.
    """

    def look(failure: Failure) -> Iterator[Finding]:
        if failure.facts.get('about') == name or failure.type in types or failure.message in texts:
            yield report(failure)

    return rule(name, what=what, do=do, **{'level': 'error', **options})(look)


def in_share(text: str) -> str:
    """Return a path, or a message with paths, that begins at `share` or `lib` in place of the folder of a simulated build."""
    return re.sub(r'\S*/edulaunch-[^/\s]+/[^/]+/(?=(?:share|lib)/)', '', text)


def report(failure: Failure, **facts: Any) -> Finding:
    """Return a finding about an error, with the facts of the error and the facts that the rule adds."""
    kind, name = ('process', failure.process) if failure.process else ('file', os.path.basename(failure.file or ''))
    return Finding(kind, name or '', {**failure.facts, **facts}, failure.file, failure.line, failure.time_s)
