"""What a failed check advises: first the kind of thing to look at, then the thing, at last how it is written.

A rubric's author may give the steps (``try: [first, second, third]``). Of a single piece of advice the steps before it are
made here: the kind of thing that it speaks of, and the advice itself without what stands in brackets.
"""

from __future__ import annotations

import re
from dataclasses import replace

from .judging import LAUNCHES
from .repeated import REPEATS
from .results import FAILED, CheckResult

KIND, THING, ALL = LEVELS = 1, 2, 3
TRIES = {THING: 2, ALL: 4}
"""From which different text on a level is reached."""
UNSAID = (LAUNCHES, REPEATS, 'own_variant')
"""Checks that no rubric has: whether it runs at all is no task, and is said at once."""

WORDS = {
    'a name: compare it letter by letter with the task': ('did you mean',),
    'a DeclareLaunchArgument': ('DeclareLaunchArgument',),
    'an IncludeLaunchDescription': ('IncludeLaunchDescription',),
    'a static_transform_publisher': ('static_transform_publisher',),
    'an event handler': ('RegisterEventHandler',),
    'an action that waits': ('TimerAction',),
    'a group with a namespace': ('PushRosNamespace',),
    'a remapping of a Node': ('remappings',),
    'a parameter of a Node': ('parameters=', 'parameter ', 'ros2 param '),
    'a Node with a namespace': ('namespace',),
    'a condition of an action': ('condition',),
    'a command that the launch file starts': ('ExecuteProcess', 'ros2 topic pub'),
    'a frame': ('view_frames', 'the frame '),
    'a broadcaster of a frame': ('broadcaster',),
    'a file that the package installs': ('data_files',),
    'a launch argument': ('argument',),
    'a topic that a node listens to': ('listen',),
    'a topic that somebody publishes on': ('publish',),
    'a Node': ('the node /', 'Node'),
}
"""Kinds of things, and the words of an advice, or else of what is wrong, that speak of one; the first that is found counts."""
_INSIDE = ((re.compile(r'(?<=[\w=])\([^()\[\]]*\)'), '\0'), (re.compile(r'(?<=[\w=])\[[^()\[\]]*\]'), '\1'))
_DEEPEST = 6


def at_level(result: CheckResult, level: int) -> CheckResult:
    """The result as it is told at a level: with less advice; at KIND without a cause, unless an error ended a program."""
    if result.status != FAILED or level >= ALL or result.name in UNSAID:
        return result
    given = (*result.steps, result.try_)
    step = given[min(level, len(given)) - 1] if result.steps else None
    if step is None:
        step = kind_of(result) if level == KIND or result.try_ is None else without_code(result.try_)
    return replace(result, try_=step, cause=result.cause if level > KIND or _has_ended(result) else None)


def _has_ended(result: CheckResult) -> bool:
    """Whether a program could not go on: what Python or ROS 2 said of it is no answer, and nobody finds it without."""
    from edulaunch.advice.registry import rule_named

    cause = result.cause
    return cause is not None and cause.kind == 'process' and rule_named(cause.rule).level == 'error'


def kind_of(result: CheckResult) -> str:
    """The kind of thing that a result is about, in a sentence."""
    advice = result.try_ or ''
    for text in (advice.partition('Otherwise: ')[2] or advice, result.reason, result.sentence):
        thing = next((kind for kind, words in WORDS.items() if any(word in text for word in words)), None)
        if thing is not None and ':' in thing:
            return thing
        if thing is not None:
            return f'{thing} is missing' if result.reason.endswith('missing') else f'{thing} is not yet as it should be'
    return without_code(result.try_) if result.try_ else 'compare what was expected with what was seen'


def without_code(advice: str) -> str:
    """An advice without what stands in the brackets of its code: ``Node(...)``, ``parameters=[...]``."""
    for _ in range(_DEEPEST):
        before = advice
        for pattern, sign in _INSIDE:
            advice = pattern.sub(sign, advice)
        if advice == before:
            break
    return advice.replace('\0', '(...)').replace('\1', '[...]')


def level_of(tries: int, hints: list[int], untouched: bool) -> int:
    """How much is said after so many different texts and with these hints open; of what was tried first only the kind."""
    if untouched:
        return KIND
    reached = max((level for level, least in TRIES.items() if tries >= least), default=KIND)
    return max([reached, *(level for level in hints if level in LEVELS)])
