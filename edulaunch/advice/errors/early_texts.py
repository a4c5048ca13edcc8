"""Values of a launch file that are put together before they are known."""

from __future__ import annotations

import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import speak
from edulaunch.advice.failure import Failure
from edulaunch.advice.finding import Finding
from edulaunch.advice.launch_names import class_named
from edulaunch.advice.rule import rule

_JOINED = re.compile(
    r"""can only concatenate str \(not "(?P<plus>\w+)"\)|unsupported operand type\(s\) for \+: '(?P<left>\w+)'"""
    r"""|bad operand type for unary -: '(?P<minus>\w+)'|[^<]*<launch[\w.]*\.substitutions\.[\w.]*\.(?P<text>\w+) object at""",
    re.DOTALL,
)


@rule(
    'launch.joined-too-early',
    what='{given} has no value yet while the launch file is read, so Python cannot make a text of it',
    do="put the parts into a list, and launch joins them later: ['carrot_', {given}(...)]",
    level='error',
)
def joined_too_early(failure: Failure) -> Iterator[Finding]:
    """`'carrot_' + LaunchConfiguration('leader')`, an f-string around it, or a minus in front."""
    said = _JOINED.match(failure.message)
    given = (
        next(filter(None, said.groups()), None)
        if said is not None and not failure.facts.get('about') and failure.process is None
        else None
    )
    if given not in (None, 'TextSubstitution') and hasattr(class_named(given), 'perform'):
        yield speak(failure, given=given)
