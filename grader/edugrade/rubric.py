"""The rubric of an exercise, with its runs and checks. A check is a function with points and with the checks that it needs."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from random import Random
from typing import Any, NamedTuple

from edulaunch.errors import UnusableInput

from .evidence import Evidence, Scenario

CheckFunction = Callable[[Evidence], None]


class NoSuchCheck(UnusableInput):
    """A rubric has no check with the requested name."""


class Check(NamedTuple):
    """One check of a rubric. Call it with the evidence: it returns if the check passes, and otherwise raises Failure.

    :param name: the name of the function, which identifies the check in the JSON report.
    :param sentence: the sentence that the student reads.
    :param function: the function of the check.
    :param points: the points for passing the check.
    :param needs: the checks that must pass before the result of this check is useful.
    :param explained_by: the names of earlier checks. While one of them does not pass, a failure of this check is not reported.
    """

    name: str
    sentence: str
    function: CheckFunction
    points: int = 0
    needs: tuple[Check, ...] = ()
    explained_by: tuple[str, ...] = ()

    def __call__(self, run: Evidence) -> None:
        self.function(run)


def check(
    *, points: int = 0, needs: Sequence[Check] = (), explained_by: Sequence[Check] = ()
) -> Callable[[CheckFunction], Check]:
    """Turn a function into a check. The first line of its docstring is the sentence that the student reads.

    :raises ValueError: if the function has no docstring, or the points are negative.
    """

    def make(function: CheckFunction) -> Check:
        name = getattr(function, '__name__', 'check')
        text = (function.__doc__ or '').strip()
        if not text:
            raise ValueError(f'the check {name}() has no docstring; its first line is the sentence the student reads')
        if not isinstance(points, int) or points < 0:
            raise ValueError(f'the check {name}() has {points!r} points; points are whole numbers, and never negative')
        if not all(isinstance(need, Check) for need in needs):
            raise ValueError(f'the check {name}() needs {needs!r}; write check functions, not their names')
        causes = tuple(each.name for each in explained_by)
        return Check(name, text.splitlines()[0].strip(), function, points, tuple(needs), causes)

    return make


LONGEST_S = 3600.0


class RubricMistake(Exception):
    """A rubric has a mistake. The message begins with the file and the line of the mistake. Nothing is graded with the rubric."""


class Rubric:
    """The scenarios and checks of one exercise.

    :param title: the exercise in a few words.
    :param scenarios: a function that creates the runs from a random generator. The content of the submission is the seed of
        the generator. So the values of a run change with every edit, and a student cannot write them into the file.
    :param checks: the checks in the order of the report. Each check comes after the checks that it needs.
    :param of: the file that the student writes in a lesson's turn, relative to the folder of the lessons.
    :param launch: the content of a launch file that starts the student's file, if that is not a launch file itself.
    :param beside: other files that an edit may change.
    :param names: the names that a cell defines, for a task without a file. There are then no runs.
    :param ended: an executable whose programs a turn ends after the duration of a run, to show what else ends then.
    :param decoys: the share of the points that a submission may get with the solution's names but without its behaviour.
    :raises ValueError: if two checks have the same name, or a check comes before a check that it needs.
    """

    def __init__(
        self,
        *,
        title: str,
        scenarios: Callable[[Random], Sequence[Scenario]] = lambda random: (),
        checks: Sequence[Check],
        of: str = '',
        launch: str = '',
        beside: Sequence[str] = (),
        names: Sequence[str] = (),
        ended: str = '',
        decoys: float = 0.5,
    ) -> None:
        self.title, self.decoys = title, decoys
        self.of, self.launch, self.beside, self.names = of, launch, tuple(beside), tuple(names)
        self.ended = ended
        self.file, self.text = '', b''  # the function that reads the file reports the error
        self.checks = tuple(checks)
        self._scenarios = scenarios
        _refuse_disorder(self.checks)

    @property
    def sha256(self) -> str:
        """The SHA-256 digest of the rubric's file."""
        from hashlib import sha256

        return sha256(self.text).hexdigest()

    def part(self, name: str) -> Rubric:
        """Return a rubric with only one check and the checks that it needs.

        :raises NoSuchCheck: if the rubric has no check with this name.
        """
        known = {check.name: check for check in self.checks}
        if name not in known:
            from edulaunch.engine.nearest import nearest

            alike = [check for check in known if nearest(name, check.split('_'))]  # often, only a part of a long name is written
            close = nearest(name, known) or next(iter(alike), None)
            hint = f'write {close}, or ' if close else ''
            missing = f'the rubric "{self.title}" has no check named "{name}"'
            raise NoSuchCheck(missing, help=f'{hint}use one of its checks: {", ".join(known)}')
        wanted = {name}
        for check in reversed(self.checks):  # a check comes after the checks that it needs
            if check.name in wanted:
                wanted |= {need.name for need in check.needs}
        part = copy(self)
        part.checks = tuple(item for item in self.checks if item.name in wanted)
        return part

    def with_points(self, points: Mapping[str, int]) -> Rubric:
        """Return the same rubric with other points for some checks.

        :param points: the points by the name of the check.
        :raises ValueError: for an unknown check or invalid points.
        """
        odd = [name for name in points if name not in {check.name for check in self.checks}]
        if odd:
            raise ValueError(f'there is no check {odd[0]}; there are {", ".join(check.name for check in self.checks)}')
        wrong = [value for value in points.values() if not isinstance(value, int) or isinstance(value, bool) or value < 0]
        if wrong:
            raise ValueError(f'{wrong[0]!r} points; points are whole numbers, and never negative')
        made: dict[str, Check] = {}
        for check in self.checks:
            needs = tuple(made[need.name] for need in check.needs)
            made[check.name] = check._replace(points=points.get(check.name, check.points), needs=needs)
        known = copy(self)
        known.checks = tuple(made.values())
        return known

    def scenarios(self, seed: int) -> tuple[Scenario, ...]:
        """Return the scenarios for a seed. The same seed gives the same scenarios.

        :raises RubricMistake: if the scenarios are invalid.
        """
        made = self._scenarios(Random(seed))
        _refuse_odd_runs(made, self._scenarios)
        return tuple(
            scenario._replace(seed=Random(f'{seed} {scenario.name}').getrandbits(31)) if scenario.seed == 0 else scenario
            for scenario in made
        )


def _refuse_odd_runs(made: Any, by: Callable[..., Any]) -> None:
    code = getattr(by, '__code__', None)
    place = f'{code.co_filename}:{code.co_firstlineno}' if code else 'the rubric'
    if not isinstance(made, (list, tuple)) or not made or not all(isinstance(item, Scenario) for item in made):
        raise RubricMistake(f'{place}: scenarios(random) must return a list of Scenario, and at least one')
    names = [item.name for item in made]
    if len(set(names)) < len(names):
        raise RubricMistake(f'{place}: two scenarios have one name: {", ".join(names)}')
    for item in made:
        if not 0.0 < item.duration_s <= LONGEST_S or not all(
            isinstance(word, str) for pair in item.arguments.items() for word in pair
        ):
            raise RubricMistake(
                f'{place}: the scenario {item.name} lasts {item.duration_s} s with {dict(item.arguments)}; '
                f'a duration is more than 0 and at most {LONGEST_S:g} s, and arguments are strings'
            )


def _refuse_disorder(checks: Sequence[Check]) -> None:
    known: dict[str, Check] = {}
    strange = next((check for check in checks if not isinstance(check, Check)), None)
    if strange is not None:
        raise TypeError(f'{strange!r} is not a check; put @check(points=...) before the function')
    for check in checks:
        if check.name in known:
            raise ValueError(f'two checks are called {check.name}')
        for need in check.needs:
            if known.get(need.name) is not need:
                raise ValueError(f'{check.name} needs {need.name}, which is not before it in the rubric')
        known[check.name] = check
