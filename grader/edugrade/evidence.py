"""What a check looks at, and the ways in which it says no.

A rubric asks for runs (`Scenario`), each comes to something (`Outcome`); those that were recorded are the `Evidence`.

::

    Failure           what is wrong, and what would put it right
    ├── Missing       something that should be there is not; names the nearest thing that is
    └── Mismatch      something is there, but is not what was asked for
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from .source import Place, Source

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording


class Scenario(NamedTuple):
    """A named launch of the submission.

    :param arguments: launch arguments, as in ``ros2 launch file name:=value``.
    :param duration_s: simulated seconds.
    :param seed: of the simulation; it decides the randomness of the students' nodes. 0: the rubric's seed decides it.
    :param is_interrupted: whether launch gets Ctrl-C at the end, after what is recorded, and the bags are read that are written.
    :param defaults: arguments that the run does not give, with the default that the launch file should declare for each; None:
        any default. See `edugrade.bare_runs`.
    """

    name: str
    arguments: Mapping[str, str] = MappingProxyType({})
    duration_s: float = 20.0
    seed: int = 0
    is_interrupted: bool = False
    defaults: Mapping[str, str | None] = MappingProxyType({})

    @property
    def command(self) -> str:
        """The arguments as they are typed after ``ros2 launch``."""
        return ' '.join(f'{name}:={value}' for name, value in self.arguments.items())

    @property
    def words(self) -> str:
        """The arguments, or that there are none: for sentences."""
        return self.command or 'no arguments'


class Outcome(NamedTuple):
    """Either a recording, or in words why there is none.

    :param kind: 'recorded'; 'unusable' (the launch file cannot be run); 'stopped' (the run did not come to
        its end); 'broke' (the grader or the engine failed, which is never the student's loss).
    """

    scenario: Scenario
    kind: str
    recording: Recording | None = None
    text: str = ''
    try_: str | None = None
    where: Place | None = None
    sandbox: Mapping[str, str] = MappingProxyType({})  # which layers of confinement held: 'held', or why not
    detail: str = ''  # for the course author: a traceback of the engine, or what the program printed
    refused: tuple[str, ...] = ()  # names of the system calls that it tried and may not make
    bags: Sequence[Mapping[str, Any]] = ()  # what the bags hold that it wrote; see `sandbox.bags`
    real_s: float = 0.0  # how long the run took on this computer; in no report, for equal runs report alike
    bare: tuple[str, tuple[str, ...]] | None = (
        None  # why it could not be launched without some of its `defaults`, and their names
    )


Found = TypeVar('Found')


class Evidence(Mapping[str, 'Recording']):
    """The recording of each scenario by its name, in the rubric's order.

    :ivar source: the submission as text, for saying where a thing belongs. Marks never depend on it.
    :ivar names: what the cells of a notebook have defined, of the names that the rubric of a turn looks at.
    :ivar bags: what the bags of each scenario hold that is interrupted, by its name.
    :ivar bare: of each scenario that could not be launched without some of its `defaults`, and was given them: why, which.
    """

    def __init__(
        self,
        scenarios: Mapping[str, Scenario],
        recordings: Mapping[str, Recording],
        source: Source,
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
        """The same for some of the scenarios."""
        recordings = {name: self[name] for name in self if name in names}
        return Evidence(self._scenarios, recordings, self.source, self.names, self.bags, self.bare)

    @property
    def first(self) -> Recording:
        """The recording of the first scenario: enough for facts that are the same in every run."""
        return next(iter(self._recordings.values()))

    def once(self, key: Hashable, find: Callable[[], Found]) -> Found:
        """What `find` gives, found once for all checks: for what takes long and is asked again and again."""
        if key not in self._found:
            self._found[key] = find()
        found: Found = self._found[key]
        return found

    def scenario(self, name: str) -> Scenario:
        """The scenario of that name: its arguments, duration and seed."""
        return self._scenarios[name]

    def arguments_of(self, name: str) -> Mapping[str, str]:
        """The launch arguments of a scenario: as they were given, or as their defaults should be, or else are declared."""
        scenario = self._scenarios[name]
        found = dict(scenario.arguments)
        for key, wanted in scenario.defaults.items():
            found[key] = wanted if wanted is not None else written_text(described_defaults(self[name]).get(key) or '')
        return found


def described_defaults(recording: Recording) -> dict[str, str | None]:
    """The default of each declared launch argument as it is described; None: it has none."""
    return {item.name: item.default for item in recording.launch.declared}


_JOINT = "' + '"  # between the parts of a text, as `ros2 launch --show-args` prints them


def written_text(described: str) -> str:
    """The text behind a description such as ``'1' + '.0'``; another substitution stays as it is described."""
    if len(described) >= 2 and described[0] == described[-1] == "'":
        return described[1:-1].replace(_JOINT, '')
    return described


class Failure(Exception):
    """Raised by a check: the submission does not do what the check's sentence says.

    :param rationale: one sentence that says what is wrong, naming the thing.
    :param expected: what was looked for, in words or as a value.
    :param seen: what was there instead.
    :param where: (file, line) of the launch action or the file to change.
    :param try_: the first thing to try; or several texts, of which a student sees the next one after some tries.
    :param share: of the points, that are given all the same: from 0 up to, not including, 1.
    """

    def __init__(
        self,
        rationale: str,
        *,
        expected: object = None,
        seen: object = None,
        where: tuple[str, int | None] | None = None,
        try_: str | Sequence[str] | None = None,
        share: float = 0.0,
    ) -> None:
        super().__init__(rationale)
        self.rationale = rationale
        self.expected = None if expected is None else str(expected)
        self.seen = None if seen is None else str(seen)
        self.where = None if where is None else Place(*where)
        texts = [try_] if isinstance(try_, str) else list(try_ or ())
        self.steps, self.try_ = tuple(texts[:-1]), texts[-1] if texts else None
        self.share = share if 0.0 <= share < 1.0 else 0.0


class Missing(Failure):
    """Something is absent.

    :param thing: what is absent, with its name, such as ``the launch argument "circle_radius"``.
    :param name: the bare name that was looked for; with `among`, the report asks whether the student meant the nearest one.
    :param among: the names that are there.
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
        try_: str | Sequence[str] | None = None,
    ) -> None:
        known = list(among)
        if seen is None:
            seen = ', '.join(known) if known else 'nothing of the kind'
        super().__init__(f'{thing} is missing', expected=expected or name, seen=seen, where=where, try_=try_)
        self.name, self.known, self._may_ask = name, known, try_ is None or isinstance(try_, str)

    def ask(self, texts: Iterable[str]) -> None:
        """Put the question "did you mean ...?" before the advice, where the student wrote a name that is near to the missing one.

        :param texts: what the student wrote. A name that stands nowhere in them is no slip of the student's.
        """
        name, try_ = self.name, self.try_
        if name is None or name in self.known or not self._may_ask:
            return
        from edulaunch.engine.nearest import nearest

        close = nearest(name, self.known)
        if close is not None and any(close.rpartition('/')[2] in text for text in texts):
            question = f'did you mean "{name}" where you wrote "{close}"?'
            self.try_ = question if try_ is None else f'{question} Otherwise: {try_}'


class Mismatch(Failure):
    """Something is there with another value; both values are shown in full, never shortened."""

    def __init__(
        self,
        thing: str,
        expected: object,
        seen: object,
        *,
        where: tuple[str, int | None] | None = None,
        try_: str | Sequence[str] | None = None,
        share: float = 0.0,
    ) -> None:
        words = f'{thing} is not what was asked for'
        super().__init__(words, expected=expected, seen=seen, where=where, try_=try_, share=share)
