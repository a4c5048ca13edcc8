"""The evidence that a check examines, and the exceptions that a check raises when it fails.

A rubric requests runs (`Scenario`). Each run has an `Outcome`. The recorded runs are the `Evidence`.

::

    Failure           what is wrong, and how to correct it
    ├── Missing       an expected thing does not exist
    └── Mismatch      a thing exists with another value
"""

from __future__ import annotations

import re
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from .source import Place, SubmittedText

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

_AT_THE_LIMIT = re.compile(r'of\sreal\stime$')
# The end of the message of a run that was stopped because it took too long. As a pattern, it needs no translation.


class Scenario(NamedTuple):
    """A named launch of the submission.

    :param arguments: launch arguments, as in ``ros2 launch file name:=value``.
    :param duration_s: the duration of the run in simulated seconds.
    :param seed: the seed of the simulation, which determines the random numbers of the students' nodes. 0 means the rubric's
        seed.
    :param is_interrupted: whether launch gets Ctrl-C after the recorded part of the run. The grader then reads the bags.
    :param defaults: arguments that the run does not pass, each with the default that the launch file should declare. None
        means any default. See `edugrade.bare_runs`.
    :param late: for each executable of edulaunch, the delay of its first start in simulated seconds. The second start has twice
        this delay, and so on. The submission cannot read `late` or `sent`. So a clock cannot replace a node that receives
        messages.
    :param sent: for each topic, the simulated time in seconds and the string that the grader publishes as std_msgs/msg/String.
    :param turned: for each turtle, such as ``/turtle1``, the simulated time in seconds and the angle in radians of a turn.
        A follower that only repeats a known path then loses the turtle.
    :param fails: the programs whose first start fails, each given as an executable or as the first words of a command. Actions
        that wait for this start must not run. A timer does not wait for it, and neither does a later action in a list.
    """

    name: str
    arguments: Mapping[str, str] = MappingProxyType({})
    duration_s: float = 20.0
    seed: int = 0
    is_interrupted: bool = False
    defaults: Mapping[str, str | None] = MappingProxyType({})
    late: Mapping[str, float] = MappingProxyType({})
    sent: Mapping[str, tuple[float, str]] = MappingProxyType({})
    turned: Mapping[str, tuple[float, float]] = MappingProxyType({})
    fails: Sequence[str] = ()

    @property
    def command(self) -> str:
        """The launch arguments, as users type them after ``ros2 launch``."""
        return ' '.join(f'{name}:={value}' for name, value in self.arguments.items())

    @property
    def hidden(self) -> dict[str, Any]:
        """The values that the submission must not know. The trusted peer gets them after it has forked the confined peer."""
        return {'late': dict(self.late), 'sent': dict(self.sent), 'turned': dict(self.turned), 'fails': list(self.fails)}

    @property
    def words(self) -> str:
        """The arguments in words for a sentence, or 'no arguments', and the programs that cannot start."""
        words = self.command or 'no arguments'
        for each in self.fails:
            words = f'{words} and a {each} that cannot start'
        return words


class Outcome(NamedTuple):
    """The recording of a run, or the reason why there is no recording.

    :param kind: 'recorded', 'unusable' (the launch file cannot be run), 'stopped' (the run did not end normally) or 'broke'.
        The kind 'broke' means that the grader or the engine failed, which costs the student no points.
    """

    scenario: Scenario
    kind: str
    recording: Recording | None = None
    text: str = ''
    try_: str | None = None
    where: Place | None = None
    sandbox: Mapping[str, str] | None = MappingProxyType({})  # for each layer 'held', or why not; None if nothing was run
    detail: str = ''  # for the course author: a traceback of the engine, or the output of the program
    refused: tuple[str, ...] = ()  # names of forbidden system calls that the run tried
    bags: Sequence[Mapping[str, Any]] = ()  # content of the bags that the run wrote; see `sandbox.bags`
    real_s: float = 0.0  # duration of the run on this computer; reports leave it out, because equal runs have equal reports
    bare: tuple[str, tuple[str, ...]] | None = (
        None  # why the launch failed without some of its `defaults`, and the names of those
    )

    @property
    def may_be_unfinished_by_chance(self) -> bool:
        """Whether the grader or, perhaps, a busy computer is the reason why the run has no recording."""
        return self.kind == 'broke' or (self.kind == 'stopped' and bool(_AT_THE_LIMIT.search(self.text)))


Found = TypeVar('Found')
Advice = str | Sequence[str] | None
"""What to do, in one step or in several steps that become more specific."""


class Evidence(Mapping[str, 'Recording']):
    """The recording of each scenario by its name, in the rubric's order.

    :ivar source: the lines of the submission, which give the places in reports. Marks never depend on them.
    :ivar names: the values that notebook cells have defined, for the names that the rubric of a lesson's check uses.
    :ivar bags: the contents of the bags of each interrupted scenario, by the scenario's name.
    :ivar bare: for each scenario that could not be launched without some of its `defaults`, the reason and the names of these
        arguments.
    """

    def __init__(
        self,
        scenarios: Mapping[str, Scenario],
        recordings: Mapping[str, Recording],
        source: SubmittedText,
        names: Mapping[str, Any] = MappingProxyType({}),
        bags: Mapping[str, Sequence[Mapping[str, Any]]] = MappingProxyType({}),
        bare: Mapping[str, tuple[str, tuple[str, ...]]] = MappingProxyType({}),
    ) -> None:
        self._scenarios = dict(scenarios)
        self._recordings = dict(recordings)
        self.bags, self.bare = dict(bags), dict(bare)
        self.source = source
        self.names = names
        self._found: dict[Hashable, Any] = {}

    def __getitem__(self, scenario: str) -> Recording:
        return self._recordings[scenario]

    def __iter__(self) -> Iterator[str]:
        return iter(self._recordings)

    def __len__(self) -> int:
        return len(self._recordings)

    def only(self, names: Sequence[str]) -> Evidence:
        """Return the evidence that contains only the named scenarios."""
        recordings = {name: self[name] for name in self if name in names}
        return Evidence(self._scenarios, recordings, self.source, self.names, self.bags, self.bare)

    @property
    def first(self) -> Recording:
        """The recording of the first scenario. Use it for facts that are the same in every run."""
        return next(iter(self._recordings.values()))

    def once(self, key: Hashable, find: Callable[[], Found]) -> Found:
        """Return the result of `find`. All calls with the same `key` share one call of `find`, which saves time if checks
        repeat it.
        """
        if key not in self._found:
            self._found[key] = find()
        found: Found = self._found[key]
        return found

    def scenario(self, name: str) -> Scenario:
        """Return the scenario with this name, which has its arguments, duration and seed."""
        return self._scenarios[name]

    def arguments_of(self, name: str) -> Mapping[str, str]:
        """Return the launch arguments of a scenario: the given values and the expected defaults.

        If a scenario accepts any default, the declared default is used.
        """
        scenario = self._scenarios[name]
        found = dict(scenario.arguments)
        for key, wanted in scenario.defaults.items():
            found[key] = wanted if wanted is not None else written_text(described_defaults(self[name]).get(key) or '')
        return found


def described_defaults(recording: Recording) -> dict[str, str | None]:
    """Return the description of each declared launch argument's default, by name. An argument without a default has the value
    None.
    """
    return {item.name: item.default for item in recording.launch.declared}


_JOINT = "' + '"  # separates the parts of a string in the output of `ros2 launch --show-args`


def written_text(described: str) -> str:
    """Return the string that a description such as ``'1' + '.0'`` represents. Other substitutions stay as described."""
    if len(described) >= 2 and described[0] == described[-1] == "'":
        return described[1:-1].replace(_JOINT, '')
    return described


class Failure(Exception):
    """A check raises this exception if the submission does not do what the check's sentence requires.

    :param rationale: one sentence that states what is wrong, with names and values.
    :param expected: what the check expected, in words or as a value.
    :param seen: what the check found instead.
    :param where: (file, line) of the launch action or the file to change.
    :param try_: what to do, beginning with a verb. If there are several strings, students get a later string after more
        attempts.
    :param share: the share of the points that the check still gives: at least 0 and less than 1.
    :param name: the bare name that the check looked for. With `among`, the report advises to correct the nearest name.
    :param among: the names that exist.
    :ivar fits_rubric: whether the advice is that of the rubric, so that its steps lead to it.
    """

    fits_rubric = True

    def __init__(
        self,
        rationale: str,
        *,
        expected: object = None,
        seen: object = None,
        where: tuple[str, int | None] | None = None,
        try_: Advice = None,
        share: float = 0.0,
        name: str | None = None,
        among: Iterable[str] = (),
    ) -> None:
        super().__init__(rationale)
        self.rationale = rationale
        self.expected = None if expected is None else str(expected)
        self.seen = None if seen is None else str(seen)
        self.where = None if where is None else Place(*where)
        texts = [try_] if isinstance(try_, str) else list(try_ or ())
        self.steps, self.try_ = tuple(texts[:-1]), texts[-1] if texts else None
        self.share = share if 0.0 <= share < 1.0 else 0.0
        self.name, self.known = name, list(among)

    def correct(self, texts: Iterable[str]) -> None:
        """Advise to correct a name that the student wrote and that is similar to the expected name, instead of the other advice.

        :param texts: what the student wrote. The advice never names anything that is not a whole word of these strings.
        """
        name = self.name
        if name is None or name in self.known:
            return
        from edulaunch.engine.nearest import nearest

        close = nearest(name, self.known)
        if close is None or _has_other_part(name, close):
            return
        pairs = [pair for pair in zip(name.split('/'), close.split('/'), strict=True) if pair[0] != pair[1]]
        right, wrong = pairs[0] if len(pairs) == 1 else (name, close)  # a launch file may write the parts of a name in two places
        written = re.compile(rf'(?<!\w){re.escape(wrong.rpartition("/")[2])}(?!\w)')
        if any(written.search(text) for text in texts):
            self.try_ = f'write "{right}" instead of "{wrong}"'


class Missing(Failure):
    """An expected thing does not exist.

    :param thing: the missing thing with its name, such as ``the launch argument "circle_radius"``.
    :param name: the bare name that the check looked for. With `among`, the report advises to correct the nearest name.
    :param among: the names that exist, which the report shows beside the bare name.
    """

    def __init__(
        self,
        thing: str,
        *,
        name: str | None = None,
        among: Iterable[str] = (),
        expected: object = None,
        seen: object = None,
        where: tuple[str, int | None] | None = None,
        try_: Advice = None,
    ) -> None:
        known = list(among)
        if known:  # otherwise, the name and `none` would only repeat the headline
            expected, seen = expected or name, seen or ', '.join(known)
        super().__init__(f'{thing} is missing', expected=expected, seen=seen, where=where, try_=try_, name=name, among=known)


def _has_other_part(name: str, close: str) -> bool:
    """Return whether two full names differ in a part that is another name, and not a misspelling.

    `/hall/listener` is not a misspelling of `/kitchen/listener` or `/hall/talker`, although many letters are equal.
    """
    from edulaunch.engine.nearest import nearest

    parts, others = name.split('/'), close.split('/')
    return len(parts) != len(others) or any(nearest(part, [other]) is None for part, other in zip(parts, others, strict=True))


LONGEST_VALUE = 60
"""The longest expected value, in characters, that the headline of a mismatch contains."""


class Mismatch(Failure):
    """A value differs from the expected value. The report shows both values in full.

    :param during: the arguments of the run, in words.
    """

    def __init__(
        self,
        thing: str,
        expected: object,
        seen: object,
        *,
        where: tuple[str, int | None] | None = None,
        try_: Advice = None,
        share: float = 0.0,
        during: str = '',
    ) -> None:
        wanted = str(expected)
        is_short = len(wanted) <= LONGEST_VALUE and '\n' not in wanted
        words = f'{thing} should be {wanted}' if is_short else f'{thing} is not as expected'
        words = f'{words} in the run with {during}' if during else words
        super().__init__(words, expected=expected, seen=seen, where=where, try_=try_, share=share)
