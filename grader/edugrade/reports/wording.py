"""Adapts results to their readers: the level of the advice, the language, and short paths.

A rubric's author may write the steps of the advice (``try: [first, second, third]``). If there is only one step, this module
creates the earlier steps. The first step is the kind of thing to check. The second step is the advice without the content of
its brackets. The grader writes reports in English and translates them at the end (`edulaunch.advice.reader`).
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
"""The attempt at which a student reaches a level."""

ARTICLES = ('a ', 'an ', 'the ', 'one ', 'two ')
KINDS = {
    'compare the names letter by letter with the task': (' instead of "',),
    'check which action and which event start this node': ('which event start', 'its event', 'event handler for the start'),
    'check the name and the default value of the launch argument': ('DeclareLaunchArgument', 'default_value', 'default'),
    'check which launch file is included, and which arguments it gets': ('IncludeLaunchDescription', 'launch_arguments'),
    'check the options of the static_transform_publisher': ('static_transform_publisher', 'arguments of its Node'),
    'check the events and the actions of the event handlers': ('RegisterEventHandler',),
    'check which actions wait, and for how long': ('TimerAction',),
    'check which actions are in the group with the namespace': ('PushRosNamespace',),
    'check the remappings of the node': ('remap',),
    'check the value that the launch file gives this parameter': (
        'parameters=',
        'param ',
        'parameter ',
        'in the parameters',
        ' as the value of ',
    ),
    'check the name and the namespace of the node': ('namespace',),
    'check the conditions of the actions': ('condition',),
    'check the command that the launch file starts': ('ExecuteProcess', 'ros2 topic pub'),
    'check the names of the frames': ('view_frames',),
    'check the name, the parent and the position of the frame': ('the frame ',),
    'check the parameters and the remappings of the broadcaster': ('broadcaster',),
    'check the links and the joints of the robot description': ('the joint ', 'a joint '),
    'check the names and the namespaces of the nodes': ('the list of nodes',),
    'check which files the package installs': ('data_files',),
    'check the path and the content of the parameter file': ('create this file', 'this parameter file'),
    'check what the node prints and logs': (' log ', ' logs ', ' print ', ' prints '),
    'check the call of the service': ('the service ',),
    'check where the launch argument is declared and used': ('argument',),
    'check to which topic the node subscribes': ('subscri', ' listens'),
    'check which node publishes on this topic, and whether this node starts': ('publish',),
    'check the package, the executable and the name of the node': ('the node /', 'Node', '<node ', 'node: '),
}
"""Advice that names only the kind of thing to check, with the words of an advice or a reason that belong to it. The first
kind that fits counts."""
ADDED = {
    'check the name and the default value of the launch argument': 'add a DeclareLaunchArgument to the launch file',
    'check which launch file is included, and which arguments it gets': 'add an IncludeLaunchDescription to the launch file',
    'check the options of the static_transform_publisher': 'add a static_transform_publisher to the launch file',
    'check the events and the actions of the event handlers': 'add an event handler',
    'check which actions wait, and for how long': 'add an action that waits',
    'check which actions are in the group with the namespace': 'add a group with a namespace',
    'check the name and the namespace of the node': 'add a node with a namespace',
    'check the conditions of the actions': 'add a condition to an action',
    'check the command that the launch file starts': 'add a command to the launch file',
    'check the parameters and the remappings of the broadcaster': 'add a broadcaster of this frame',
    'check where the launch argument is declared and used': 'add a launch argument',
    'check the package, the executable and the name of the node': 'add a node',
}
"""For a kind of thing that is missing: advice to add it."""
PARAMETER = 'check the value that the launch file gives this parameter'
_INSIDE = (
    (re.compile(r'(?<=\w)\(\)'), '\2'),
    (re.compile(r'(?<=[\w=])\([^()\[\]{}]*\)'), '\0'),
    (re.compile(r'(?<=[\w=])\[[^()\[\]{}]*\]'), '\1'),
    (re.compile(r'(?<=[\w=(\[ ])\{[^()\[\]{}]*\}'), '\3'),
    (re.compile(r'(?<=\w=)"[^"\n]*"'), '\4'),
    (re.compile(r"(?<=\w=)'[^'\n]*'"), '\5'),
)
_ABBREVIATED = {'\0': '(...)', '\1': '[...]', '\2': '()', '\3': '{...}', '\4': '"..."', '\5': "'...'"}
_DEEPEST = 6
LAUNCHED = ' in the run with '


def at_level(result: CheckResult, level: int) -> CheckResult:
    """Return a result with the advice of a level. At KIND, the result has no cause, unless an error ended a program."""
    if result.status == FAILED and ' died ' in result.reason:  # the cause knows more than the check
        known = 'make the change that the cause describes' if level >= ALL else 'correct the mistake that the cause names'
        return replace(result, steps=(), try_=known if _has_ended(result) else result.try_)
    # this result is not part of the task, so nothing is hidden
    if result.status != FAILED or level >= ALL or result.name in OF_NO_RUBRIC:
        needs_advice = result.status == FAILED and result.try_ is None
        return replace(result, try_=kind_of(result)) if needs_advice else result
    given = (*result.steps, result.try_)
    step = given[min(level, len(given)) - 1] if result.steps else None
    if step is not None and step.startswith(ARTICLES):
        step = f'check {step}'
    if step is None:
        step = kind_of(result) if level == KIND or result.try_ is None else without_code(result.try_)
    return replace(result, try_=step, cause=result.cause if level > KIND or _has_ended(result) else None)


def _has_ended(result: CheckResult) -> bool:
    """Return whether an error ended a program. The cause of such a failure does not reveal the answer, and the student needs
    it.
    """
    from edulaunch.advice.rule import rule_named

    cause = result.cause
    return cause is not None and cause.kind == 'process' and rule_named(cause.rule).level == 'error'


def kind_of(result: CheckResult) -> str:
    """Return advice that names only the kind of thing to check."""
    for text in (result.try_ or '', result.reason.partition(LAUNCHED)[0], result.sentence):
        advice = next((kind for kind, words in KINDS.items() if any(word in text for word in words)), None)
        if advice is None:
            continue
        if not result.reason.endswith('missing') or 'default' in result.reason:
            return advice
        if advice == PARAMETER and ' frame ' not in result.reason:
            return 'write the missing parameter into the parameters of this Node, or correct its name there'
        added = ADDED.get(advice, advice)
        return added if added == advice or not result.seen else f'{added}, or {advice}'
    return without_code(result.try_) if result.try_ else 'compare the line "expected" with the line "seen"'


def without_code(advice: str) -> str:
    """Return advice without the content of its brackets, such as ``Node(...)`` and ``parameters=[...]``."""
    for _ in range(_DEEPEST):
        before = advice
        for pattern, sign in _INSIDE:
            advice = pattern.sub(sign, advice)
        if advice == before:
            break
    for sign, short in _ABBREVIATED.items():
        advice = advice.replace(sign, short)
    return advice


def level_of(tries: int, hints: list[int], untouched: bool) -> int:
    """Return the level of advice after a number of attempts and of opened hints. The first attempt has the level KIND."""
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
)
"""Statuses and labels of one word, which the catalogue cannot recognise as sentences."""


def translated(result: CheckResult, reader: Reader) -> CheckResult:
    """Return a result with its sentences in the reader's language."""
    return replace(
        result,
        sentence=reader.retells(result.sentence),
        reason=_maybe(result.reason, reader) or '',
        expected=_maybe(result.expected, reader),
        seen=_maybe(result.seen, reader),
        try_=_maybe(result.try_, reader),
    )


def _maybe(text: str | None, reader: Reader) -> str | None:
    if text is None:
        return None
    whole = reader.retells(text)
    return whole if whole != text else '\n'.join(map(reader.retells, text.split('\n')))


def points_of(result: CheckResult, reader: Reader) -> str:
    """Return the points of a check in brackets, or '' for a check without points."""
    return f'  [{reader.retells(f"{result.earned} of {result.points}")}]' if result.points else ''


def explained(result: CheckResult, paths: ShortPaths, reader: Reader, level: int = ALL) -> dict[str, str]:
    """Return the lines that follow the reason of a failed check, as a mapping of labels to strings, for a level of advice."""
    where = None if result.where is None else str(result.where)
    fields = {'expected': result.expected, 'seen': result.seen, 'where': where, 'try': result.try_}
    if result.cause is not None:
        from edulaunch.advice import rendered

        words = rendered(result.cause._replace(file=paths.text(result.cause.file)), reader._replace(folder=''))
        where = f' ({words.where})' if words.where else ''
        fields['cause'] = paths.text(f'{words.what}{where}' + (f'\n{words.do}' if level >= ALL else ''))
    return {reader.says(label): text for label, text in fields.items() if text}


LONGEST_TEXT = 8000
_ENGINE = os.path.join(engine_folder(), '')
_WORD = re.compile(r'[^\s\'"()\[\]<>]+')
# edulaunch runs the files of a source package from a generated prefix, which links to them under this path.
_INSTALLED = re.compile(r'edulaunch-\w+/[^\s/]+-[0-9a-f]{8}/share/(?P<package>\w+)/')
_HOME = re.compile(r'edugrade-[0-9a-f]{16}/\d+')  # the private folder of a run


class ShortPaths:
    """A function object that shortens the paths in the sentences of a report.

    :param folder: the absolute path of the submission's directory.
    :param shown: the replacement for `folder`, which is '' or a path that ends in a separator.
    :param package: the name of the package in this directory, or None.
    """

    def __init__(self, folder: str, shown: str = '', package: str | None = None) -> None:
        self._folder = os.path.join(folder, '')
        self._shown = shown
        self._package = package

    def text(self, text: str | None) -> str | None:
        """Return a string with short paths and at most LONGEST_TEXT characters. None stays None."""
        if text is None:
            return None
        if len(text) > LONGEST_TEXT:
            start = shortened(text, LONGEST_TEXT)
            text = f'{start} ... and {len(text) - len(start)} more characters'
        text = text.replace(self._folder, self._shown).replace(_ENGINE, 'edulaunch/')
        if 'edulaunch-' in text or 'edugrade-' in text:
            text = _WORD.sub(lambda word: self._of_word(word[0]), text)
        if ' at 0x' not in text:
            return text
        from edulaunch.engine.processes.streams import Addresses

        return Addresses().steady(text)

    def _of_word(self, word: str) -> str:
        """Return a word without the generated folders at the beginning of a path."""
        installed = _last(_INSTALLED, word)
        if installed is not None:
            package = installed['package']
            return (self._shown if package == self._package else f'{package}/') + word[installed.end() :]
        home = _last(_HOME, word)
        return word if home is None else '~' + word[home.end() :]

    def place(self, place: Place | None) -> Place | None:
        """Return a place whose path is shortened."""
        return None if place is None else Place(self.text(place.file) or '', place.line)

    def result(self, result: CheckResult) -> CheckResult:
        """Return a result with short paths in all its strings."""
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
