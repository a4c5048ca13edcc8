"""Reads rubrics in YAML, which describe runs and checks without Python. Error messages name the file and the line of each
mistake.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import isfinite
from random import Random
from typing import Any

import yaml

from ..evidence import Evidence, Failure, Scenario
from ..rubric import Check, CheckFunction, Rubric, RubricMistake
from . import yaml_behaviour, yaml_movement  # noqa: F401  (their kinds)
from .yaml_checks import KINDS
from .yaml_wanted import ARGUMENT, Wanted

Problem = Callable[[yaml.Node, str], RubricMistake]
TURN = ('of', 'launch', 'beside', 'names')
CONSONANTS, VOWELS = 'bdfgklmnprstv', 'aeiou'
RUN = ('name', 'arguments', 'duration', 'seed', 'interrupt', 'defaults', 'late', 'sends', 'turns', 'fails')
SENT = 0.4, 0.5  # the parts of a run between which the grader sends its message, or turns a turtle
ENDS = ('ends', 'shuts_down')
COMMON = ('points', 'say', 'name', 'needs', 'explained_by', 'try', 'only')


def read_yaml_rubric(path: str, data: bytes) -> Rubric:
    """Return the rubric that a YAML file describes; docs/rubric_checks.md describes the format.

    :raises RubricMistake: with the file and line of the first mistake in each run and check.
    """
    try:
        root = yaml.compose(data, yaml.SafeLoader)
    except (yaml.YAMLError, RecursionError) as error:
        mark = getattr(error, 'problem_mark', None)
        raise RubricMistake(
            f'{path}:{mark.line + 1 if mark else 1}: {getattr(error, "problem", None) or getattr(error, "reason", error)}'
        ) from None
    if root is None:
        raise RubricMistake(f'{path}:1: the file is empty; a rubric has title, runs and checks')

    def problem(node: yaml.Node, words: str) -> RubricMistake:
        return RubricMistake(f'{path}:{node.start_mark.line + 1}: {words}')

    parts = _mapping(root, problem, 'a rubric', ('title', 'runs', 'checks', 'points', 'decoys', *TURN))
    wanted = ('title', 'checks') if 'names' in parts else ('title', 'runs', 'checks')
    missing = [name for name in wanted if name not in parts]
    if missing:
        raise problem(root, f'the rubric lacks {" and ".join(missing)}')
    runs, checks = _runs_and_checks(parts, problem)
    _refuse_unknown_arguments(parts['checks'], runs, problem)
    _refuse_unknown_proofs(parts['checks'], checks, problem)
    title = _value(parts['title'], problem)
    turn = {name: _value(parts[name], problem) for name in TURN if name in parts}
    if 'decoys' in parts:
        turn['decoys'] = float(_number(parts['decoys'], problem)(Random(0)))
    rubric = Rubric(title=str(title), scenarios=lambda random: _choose(runs, random), checks=list(checks.values()), **turn)
    if 'points' in parts:
        try:
            rubric = rubric.with_points(_value(parts['points'], problem))
        except (ValueError, TypeError, AttributeError) as error:
            raise problem(parts['points'], str(error)) from None
    try:
        if runs:
            rubric.scenarios(0)
    except RubricMistake as mistake:
        raise problem(parts['runs'], str(mistake).split(': ', 1)[1]) from None
    return rubric


def _runs_and_checks(
    parts: Mapping[str, yaml.Node], problem: Problem
) -> tuple[list[Callable[[Random], Scenario]], dict[str, Check]]:
    """Return the runs, and the checks by name.

    :raises RubricMistake: with the first mistake in each run and check, one on each line.
    """
    runs: list[Callable[[Random], Scenario]] = []
    names: list[str] = []
    checks: dict[str, Check] = {}
    mistakes: list[str] = []
    for node in _items(parts['runs'], problem, 'runs') if 'runs' in parts else ():
        try:
            runs.append(_run(node, problem))
            names.append(runs[-1](Random(0)).name)  # finds a mistake in the rubric now, before the first submission
        except RubricMistake as mistake:
            mistakes.append(str(mistake))
            names.append(_name_in(node))
    items = _items(parts['checks'], problem, 'checks')
    may_end = any(pair[0].value in ENDS for item in items if isinstance(item, yaml.MappingNode) for pair in item.value)
    for node in items:
        try:
            check = _check(node, problem, checks, names, may_end)
        except RubricMistake as mistake:
            mistakes.append(str(mistake))
            check = Check(_name_in(node), '', lambda run: None, 0)  # other checks may need it
        checks.setdefault(check.name, check)
    if mistakes:
        raise RubricMistake('\n'.join(mistakes))
    return runs, checks


def _name_in(node: yaml.Node) -> str:
    """Return the name of a run or check that has a mistake, or '' if it has no name."""
    pairs = node.value if isinstance(node, yaml.MappingNode) else ()
    return next((str(value.value) for key, value in pairs if key.value == 'name'), '')


def _choose(runs: list[Callable[[Random], Scenario]], random: Random) -> list[Scenario]:
    return [run(random) for run in runs]


def _run(node: yaml.Node, problem: Problem) -> Callable[[Random], Scenario]:
    parts = _mapping(node, problem, 'a run', RUN)
    if 'name' not in parts:
        raise problem(node, 'a run needs a name')
    name = _string(parts['name'], problem, 'name')
    given = _mapping(parts['arguments'], problem, 'arguments', None) if 'arguments' in parts else {}
    arguments = {key: _argument(value, problem) for key, value in given.items()}
    usual = _mapping(parts['defaults'], problem, 'defaults', None) if 'defaults' in parts else {}
    defaults = {key: _default(value, problem) for key, value in usual.items()}
    twice = next((value for key, value in usual.items() if key in given), None)
    if twice is not None:
        raise problem(twice, 'write an argument in arguments or in defaults, and not in both')
    duration = _number(parts['duration'], problem, (int, float)) if 'duration' in parts else (lambda random: 20.0)
    late, sent = (_mapping(parts[key], problem, key, None) if key in parts else {} for key in ('late', 'sends'))
    delays = {key: _number(value, problem, (int, float)) for key, value in late.items()}
    texts = {key: _message(value, problem) for key, value in sent.items()}
    turned = _mapping(parts['turns'], problem, 'turns', None) if 'turns' in parts else {}
    angles = {key: _number(value, problem, (int, float)) for key, value in turned.items()}
    fails = _value(parts['fails'], problem) if 'fails' in parts else []
    if not isinstance(fails, list) or not all(isinstance(each, str) for each in fails):
        raise problem(parts['fails'], f'fails is {fails!r}; write a list of executables, or of the first words of commands')
    seed = _value(parts['seed'], problem) if 'seed' in parts else 0
    if not isinstance(seed, int):
        raise problem(parts['seed'], f'seed is {seed!r}; write a whole number')
    is_interrupted = _value(parts['interrupt'], problem) if 'interrupt' in parts else False
    if not isinstance(is_interrupted, bool):
        raise problem(parts['interrupt'], f'interrupt is {is_interrupted!r}, and true or false is expected')

    def chosen(random: Random) -> Scenario:
        values = {key: of(random) for key, of in arguments.items()}
        length_s = float(duration(random))
        hidden = {key: float(of(random)) for key, of in delays.items()}
        unknown = next((one for topic in texts for one in ARGUMENT.findall(topic) if one not in values), None)
        if unknown is not None:
            raise problem(parts['sends'], f'the run {name} has no argument {unknown}')
        to_publish = {
            ARGUMENT.sub(lambda found: values[found[1]], topic): (when(random, length_s), of(random))
            for topic, (when, of) in texts.items()
        }
        turns = {f'/{key.strip("/")}': (_some_time(random, length_s), float(of(random))) for key, of in angles.items()}
        return Scenario(name, values, length_s, seed, is_interrupted, defaults, hidden, to_publish, turns, tuple(fails))

    return chosen


def _argument(node: yaml.Node, problem: Problem) -> Callable[[Random], str]:
    """Return a function that returns the value of a launch argument, which is fixed or selected for each submission."""
    if isinstance(node, yaml.MappingNode) and any(pair[0].value == 'word' for pair in node.value):
        syllables = _value(_mapping(node, problem, 'a choice', ('word',))['word'], problem)
        if not isinstance(syllables, int) or not 2 <= syllables <= 6:
            raise problem(node, 'word is a number of syllables from 2 to 6')
        return lambda random: ''.join(random.choice(CONSONANTS) + random.choice(VOWELS) for _ in range(syllables))
    if isinstance(node, yaml.MappingNode):
        number, decimals = _number(node, problem), _decimals(node, problem)
        return lambda random: f'{found:.{decimals}f}' if isinstance(found := number(random), float) else str(found)
    if not isinstance(node, yaml.ScalarNode):
        raise problem(node, 'an argument is a text, {between: [LOW, HIGH]}, {one_of: [...]} or {word: 3}')
    text = str(node.value)  # the text that people type after name:=
    return lambda random: text


def _some_time(random: Random, length_s: float) -> float:
    return round(random.uniform(*SENT) * length_s, 2)


def _message(node: yaml.Node, problem: Problem) -> tuple[Callable[[Random, float], float], Callable[[Random], str]]:
    """Return two functions: one selects the time of a message for a duration of the run, and the other the string of the
    message.
    """
    if not isinstance(node, yaml.MappingNode) or all(pair[0].value != 'at' for pair in node.value):
        return _some_time, _argument(node, problem)
    at = _number({pair[0].value: pair[1] for pair in node.value}['at'], problem, (int, float))
    rest = [pair for pair in node.value if pair[0].value != 'at']
    text = _argument(yaml.MappingNode(node.tag, rest, node.start_mark, node.end_mark), problem)
    return lambda random, length_s: float(at(random)), text


def _default(node: yaml.Node, problem: Problem) -> str | None:
    """Return the default that an argument must have, or None (null in YAML) for any default."""
    if not isinstance(node, yaml.ScalarNode):
        raise problem(node, 'a default must be a string, or null for any default')
    return None if _value(node, problem) is None else str(node.value)


def _number(node: yaml.Node, problem: Problem, types: tuple[type, ...] = (str, int, float)) -> Callable[[Random], Any]:
    """Return a function that returns a fixed number, or selects one of several values.

    :param types: the allowed types of the values of `one_of`.
    """
    if not isinstance(node, yaml.MappingNode):
        value = _value(node, problem)
        if not isinstance(value, (int, float)) or not isfinite(value):
            raise problem(node, f'{value!r} is not a number')
        return lambda random: value
    parts = _mapping(node, problem, 'a choice', ('between', 'one_of', 'decimals'))
    if 'one_of' in parts:
        known = _value(parts['one_of'], problem)
        if not isinstance(known, list) or not known or not all(isinstance(each, types) for each in known):
            raise problem(node, 'one_of is a list of at least one value of the right type')
        return lambda random: random.choice(known)
    ends = _value(parts['between'], problem) if 'between' in parts else None
    if not (
        isinstance(ends, list)
        and len(ends) == 2
        and all(isinstance(end, (int, float)) and isfinite(end) for end in ends)
        and ends[0] < ends[1]
    ):
        raise problem(node, 'a choice is {between: [LOW, HIGH], decimals: 2} or {one_of: [...]}')
    decimals = _decimals(node, problem)
    low, high = (round(end * 10**decimals) for end in ends)
    if not decimals:
        return lambda random: random.randint(low, high)
    return lambda random: random.randint(low, high) / 10**decimals


def _decimals(node: yaml.MappingNode, problem: Problem) -> int:
    parts = _mapping(node, problem, 'a choice', None)
    ends = _value(parts['between'], problem) if 'between' in parts else ()
    usual = 0 if isinstance(ends, list) and ends and all(isinstance(end, int) for end in ends) else 2
    decimals = _value(parts['decimals'], problem) if 'decimals' in parts else usual
    if type(decimals) is not int or not 0 <= decimals <= 6:
        raise problem(node, 'decimals is a whole number from 0 to 6')
    return decimals


def _check(node: yaml.Node, problem: Problem, known: Mapping[str, Check], runs: list[str], may_end: bool) -> Check:
    parts = _mapping(node, problem, 'a check', (*KINDS, *COMMON))
    kinds = [name for name in parts if name in KINDS]
    if len(kinds) != 1:
        raise problem(node, f'a check is one of {", ".join(KINDS)}; here are {", ".join(kinds) or "none of them"}')
    kind = KINDS[kinds[0]]
    given = {name: _value(part, problem) for name, part in _mapping(parts[kinds[0]], problem, kinds[0], kind.fields).items()}
    lacking = [name for name in kind.required if name not in given]
    if lacking:
        raise problem(parts[kinds[0]], f'{kinds[0]} lacks {" and ".join(lacking)}')
    points = _value(parts['points'], problem) if 'points' in parts else 0
    if type(points) is not int or points < 0:
        raise problem(parts['points'], f'{points!r} points; points are whole numbers, and never negative')
    words = {name: _string(parts[name], problem, name) for name in ('say', 'name') if name in parts}
    *steps, last = _advice(parts['try'], problem) if 'try' in parts else [None]
    wanted = Wanted(given, last)
    wanted.may_end = may_end
    wanted.shows = lambda run: [known[str(each)](run) for each in given.get('shows', ())]
    try:
        wanted.refuse_odd_values()
    except ValueError as error:
        raise problem(parts[kinds[0]], str(error)) from None
    name = words.get('name') or f'{kinds[0]}_{len(known) + 1}'
    if name in known:
        raise problem(node, f'two checks are called {name}')
    names, causes = (_earlier(parts, key, name, known, problem) for key in ('needs', 'explained_by'))
    only = _value(parts['only'], problem) if 'only' in parts else runs
    if 'only' in parts and (not isinstance(only, list) or not only or any(str(each) not in runs for each in only)):
        raise problem(parts['only'], f'only is a list of names of runs; there are {", ".join(runs)}')
    return Check(
        name,
        words.get('say') or kind.sentence.format_map(wanted.shown),
        _with_steps(lambda run: kind.function(run.only(only), wanted), steps),
        points,
        tuple(known[each] for each in names),
        (*causes, *map(str, given.get('shows', ()))),
    )


def _earlier(parts: Mapping[str, yaml.Node], key: str, name: str, known: Mapping[str, Check], problem: Problem) -> list[str]:
    """Return the names of earlier checks in the field `key` of a check."""
    names = _value(parts[key], problem) if key in parts else []
    if not isinstance(names, list):
        raise problem(parts[key], f'{key} is a list of names of checks')
    strange = [each for each in names if not isinstance(each, str) or each not in known]
    if strange:
        raise problem(parts[key], f'{name} needs {", ".join(map(str, strange))}, which is not before it in the rubric')
    return names


def _advice(node: yaml.Node, problem: Problem) -> list[str | None]:
    """Return the advice of a check as a list: one string, or several that become more specific."""
    items = node.value if isinstance(node, yaml.SequenceNode) else [node]
    if not items:
        raise problem(node, 'try must be a string, or a list of strings that become more specific')
    return [_string(item, problem, 'try') for item in items]


def _with_steps(function: CheckFunction, steps: Sequence[str | None]) -> CheckFunction:
    """Return a check function that adds the steps of the rubric to the failures that the rubric's advice fits."""

    def checked(run: Evidence) -> None:
        try:
            function(run)
        except Failure as failure:
            if failure.fits_rubric:
                failure.steps = tuple(filter(None, steps))
            raise

    return checked if steps else function


def _refuse_unknown_arguments(node: yaml.Node, runs: list[Callable[[Random], Scenario]], problem: Problem) -> None:
    """Raise a RubricMistake for ``$(arg name)`` if one of the runs does not have this launch argument."""
    if isinstance(node, yaml.ScalarNode):
        for name in ARGUMENT.findall(str(node.value)):
            for scenario in _choose(runs, Random(0)):
                if name not in {**scenario.arguments, **scenario.defaults}:
                    raise problem(node, f'the run {scenario.name} has no argument {name}; it has {scenario.words}')
        return
    for child in node.value:
        for each in child if isinstance(child, tuple) else (child,):
            _refuse_unknown_arguments(each, runs, problem)


def _refuse_unknown_proofs(node: yaml.Node, known: Mapping[str, Check], problem: Problem) -> None:
    """Raise a RubricMistake if `shows` is not a list of names of checks."""
    for item in node.value:
        for kind in (pair[1] for pair in item.value if isinstance(pair[1], yaml.MappingNode)):
            for part in (value for key, value in kind.value if key.value == 'shows'):
                names = _value(part, problem)
                if not isinstance(names, list) or not names or any(str(name) not in known for name in names):
                    raise problem(part, f'shows is a list of names of checks; there are {", ".join(known)}')


def _mapping(node: yaml.Node, problem: Problem, what: str, known: tuple[str, ...] | None) -> dict[str, yaml.Node]:
    if not isinstance(node, yaml.MappingNode):
        raise problem(node, f'{what} is written as "name: value" lines' + (f': {", ".join(known)}' if known else ''))
    found: dict[str, yaml.Node] = {}
    for key, value in node.value:
        name = str(key.value) if isinstance(key, yaml.ScalarNode) else '?'
        if name in found:
            raise problem(key, f'{name} is there twice')
        if known is not None and name not in known:
            from edulaunch.engine.nearest import nearest

            close = nearest(name, known)
            raise problem(key, f'{what} has no {name}; ' + (f'did you mean {close}?' if close else f'it has {", ".join(known)}'))
        found[name] = value
    return found


def _items(node: yaml.Node, problem: Problem, what: str) -> list[yaml.Node]:
    if not isinstance(node, yaml.SequenceNode) or not node.value:
        raise problem(node, f'{what} is a list, each item after a "-"')
    return list(node.value)


def _string(node: yaml.Node, problem: Problem, what: str) -> str:
    """Return a string, such as a name. A number or a date counts as its string."""
    value = _value(node, problem)
    if not isinstance(node, yaml.ScalarNode) or value is None or not str(value).strip():
        raise problem(node, f'{what} is {value!r}; write a string')
    return str(value)


def _value(node: yaml.Node, problem: Problem) -> Any:
    try:
        loader = yaml.SafeLoader('')
        return loader.construct_object(node, deep=True)
    except (yaml.YAMLError, ValueError) as error:
        raise problem(node, str(error)) from None
