"""How results are told to people: how much at which level, in the reader's language, with short paths.

A rubric's author may give the steps of an advice (``try: [first, second, third]``). Of a single piece of advice the steps before
it are made here: the kind of thing that it speaks of, and the advice itself without what stands in brackets. Reports are made in
English, and retold (`edulaunch.advice.reader`).
"""

from __future__ import annotations

import os
import re
from dataclasses import replace
from typing import TYPE_CHECKING

from edulaunch.engine.underlay_place import engine_folder

from ..results import FAILED, OF_NO_RUBRIC, CheckResult
from ..shortened import shortened
from ..source import Place

if TYPE_CHECKING:
    from edulaunch.advice import Reader

KIND, THING, ALL = LEVELS = 1, 2, 3
TRIES = {THING: 2, ALL: 4}
"""From which different text on a level is reached."""

ARTICLES = ('a ', 'an ', 'the ', 'one ', 'two ')
KINDS = {
    'compare the names letter by letter with the task': ('did you mean',),
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
    if result.status != FAILED or level >= ALL or result.name in OF_NO_RUBRIC:  # no task: said at once
        return result
    given = (*result.steps, result.try_)
    step = given[min(level, len(given)) - 1] if result.steps else None
    if step is not None and step.startswith(ARTICLES):
        step = f'check {step}'
    if step is None:
        step = kind_of(result) if level == KIND or result.try_ is None else without_code(result.try_)
    return replace(result, try_=step, cause=result.cause if level > KIND or _has_ended(result) else None)


def _has_ended(result: CheckResult) -> bool:
    """Whether a program could not go on: what Python or ROS 2 said of it is no answer, and nobody finds it without."""
    from edulaunch.advice.rule import rule_named

    cause = result.cause
    return cause is not None and cause.kind == 'process' and rule_named(cause.rule).level == 'error'


def kind_of(result: CheckResult) -> str:
    """The kind of thing that a result is about, in a sentence."""
    advice = result.try_ or ''
    for text in (advice.partition('Otherwise: ')[2] or advice, result.reason, result.sentence):
        thing = next((kind for kind, words in KINDS.items() if any(word in text for word in words)), None)
        if thing is not None and not thing.startswith(ARTICLES):
            return thing
        if thing is not None:
            return f'add what is missing: {thing}' if result.reason.endswith('missing') else f'check {thing}'
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


WORDS = (
    'ok',
    'FAILED',
    'not run',
    'BROKE',
    'expected',
    'seen',
    'where',
    'try',
    'cause',
    'no mark',
    '{earned} of {points}',
    '{first} m and {second} m',
    'failed',
    'broke',
)
"""Marks and labels: single words, which no search for sentences finds."""


def translated(result: CheckResult, reader: Reader) -> CheckResult:
    """A result with its sentences in the reader's language."""
    return replace(
        result,
        sentence=reader.retells(result.sentence),
        reason=reader.retells(result.reason),
        expected=_maybe(result.expected, reader),
        seen=_maybe(result.seen, reader),
        try_=_maybe(result.try_, reader),
    )


def _maybe(text: str | None, reader: Reader) -> str | None:
    return None if text is None else reader.retells(text)


def points_of(result: CheckResult, reader: Reader) -> str:
    """What a check earned, in brackets; '' where there is nothing to earn."""
    return f'  [{reader.retells(f"{result.earned} of {result.points}")}]' if result.points else ''


def explained(result: CheckResult, paths: ShortPaths, reader: Reader, level: int = ALL) -> dict[str, str]:
    """What stands below the reason of a failed check: label -> text, of what there is and is told at this level."""
    where = None if result.where is None else str(result.where)
    fields = {'expected': result.expected, 'seen': result.seen, 'where': where, 'try': result.try_}
    if result.cause is not None:
        from edulaunch.advice import rendered

        words = rendered(result.cause, reader._replace(folder=''))
        where = f' ({words.where})' if words.where else ''
        fields['cause'] = paths.text(f'{words.what}{where}' + (f'\n{words.do}' if level >= ALL else ''))
    return {reader.says(label): text for label, text in fields.items() if text}


LONGEST_TEXT = 8000
_ENGINE = os.path.join(engine_folder(), '')
_WORD = re.compile(r'[^\s\'"]+')
# Files of a source package are run from a generated prefix, where they are links under this path.
_INSTALLED = re.compile(r'edulaunch-\w+/[^\s/]+-[0-9a-f]{8}/share/(?P<package>\w+)/')
_HOME = re.compile(r'edugrade-[0-9a-f]{16}/\d+')  # the private folder of a run


class ShortPaths:
    """Writes texts of one report.

    :param folder: the submission's folder, absolute.
    :param shown: what is written in its place: '' or a path that ends in a separator.
    :param package: the package that this folder is, if it is one.
    """

    def __init__(self, folder: str, shown: str = '', package: str | None = None) -> None:
        self._folder = os.path.join(folder, '')
        self._shown = shown
        self._package = package

    def text(self, text: str | None) -> str | None:
        """A text with short paths, of LONGEST_TEXT characters at most; None stays None."""
        if text is None:
            return None
        if len(text) > LONGEST_TEXT:
            start = shortened(text, LONGEST_TEXT)
            text = f'{start} ... and {len(text) - len(start)} characters more'
        text = text.replace(self._folder, self._shown).replace(_ENGINE, 'edulaunch/')
        if 'edulaunch-' in text or 'edugrade-' in text:
            text = _WORD.sub(lambda word: self._of_word(word[0]), text)
        if ' at 0x' not in text:
            return text
        from edulaunch.engine.processes.streams import Addresses

        return Addresses().steady(text)

    def _of_word(self, word: str) -> str:
        """A word without the generated beginning of a path."""
        installed = _last(_INSTALLED, word)
        if installed is not None:
            package = installed['package']
            return (self._shown if package == self._package else f'{package}/') + word[installed.end() :]
        home = _last(_HOME, word)
        return word if home is None else '~' + word[home.end() :]

    def place(self, place: Place | None) -> Place | None:
        """A place with a short path."""
        return None if place is None else Place(self.text(place.file) or '', place.line)

    def result(self, result: CheckResult) -> CheckResult:
        """A result with short paths in all its texts."""
        return replace(
            result,
            reason=self.text(result.reason) or '',
            expected=self.text(result.expected),
            seen=self.text(result.seen),
            where=self.place(result.where),
            try_=self.text(result.try_),
        )


def _last(pattern: re.Pattern[str], word: str) -> re.Match[str] | None:
    found = list(pattern.finditer(word))
    return found[-1] if found else None
