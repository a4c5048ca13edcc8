"""Runs without a launch argument, which show the effect of its default.

A scenario lists in `defaults` the arguments that it does not pass. If the launch file declares another default, or no
default, the grader repeats the run with the argument. A wrong default then costs the points of its own check, and not those
of other checks. If the default is a substitution, the grader compares the run with a run that passes the argument. Both must
be identical.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

from .evidence import Outcome, Scenario, described_defaults, written_text
from .library.arguments import is_literal, is_same_value
from .library.deaths import deaths
from .worker import in_worker

Again = Callable[[list[Scenario]], Sequence[Outcome]]
Plan = Sequence[tuple[dict[str, str | None], str, dict[str, str | None]]]
ANOTHER = 'the default has another value'
NOT_COMPARED = ('/rosout', '/parameter_events')


def with_defaults_given(outcomes: Sequence[Outcome], again: Again, known: Plan | None = None) -> list[Outcome]:
    """Return the outcomes, with repeated runs in place of the original runs where arguments were needed.

    If a run accepts any default and the launch file declares none, the run is left out.

    :param again: a function that runs scenarios and returns their outcomes.
    :param known: the result of `plan_of` from a worker, or None.
    """
    if not any(outcome.scenario.defaults for outcome in outcomes):
        return list(outcomes)
    try:  # in a worker, because the declarations of a submission may crash their reader
        plan = known or in_worker(lambda: plan_of(outcomes))
    except Exception:  # judging meets the same error, and reports it
        return list(outcomes)
    places = [place for place, (names, *_) in enumerate(plan) if names and None not in names.values()]
    made = again([_giving(outcomes[place].scenario, plan[place][0]) for place in places]) if places else []
    instead = {
        place: outcome._replace(bare=(plan[place][1], tuple(plan[place][0])) if plan[place][1] else None)
        for place, outcome in zip(places, made, strict=True)
    }
    instead = _with_calculated_given(outcomes, [names for *_, names in plan], again) | instead
    return [instead.get(place, outcome) for place, outcome in enumerate(outcomes) if place in instead or not plan[place][0]]


def _with_calculated_given(
    outcomes: Sequence[Outcome], names: Sequence[Mapping[str, str | None]], again: Again
) -> dict[int, Outcome]:
    """Repeat each run that has a calculated default, with the argument. Return the runs that differ, by their positions."""
    found = {}
    places = [place for place, given in enumerate(names) if given]
    made = again([_giving(outcomes[place].scenario, names[place]) for place in places]) if places else []
    for place, outcome in zip(places, made, strict=True):
        try:
            is_other = outcome.recording is not None and in_worker(partial(_differ, outcomes[place], outcome))
        except Exception:
            continue
        if is_other:
            found[place] = outcome._replace(bare=(ANOTHER, tuple(names[place])))
    return found


def _calculated(outcome: Outcome) -> dict[str, str | None]:
    """Return the arguments of a run whose declared default is a substitution, with the expected values."""
    if outcome.recording is None or not any(outcome.scenario.defaults.values()):
        return {}
    declared = described_defaults(outcome.recording)
    return {
        name: wanted
        for name, wanted in outcome.scenario.defaults.items()
        if wanted is not None and isinstance(declared.get(name), str) and not is_literal(str(declared[name]))
    }


def _differ(one: Outcome, other: Outcome) -> bool:
    """Return whether the parameters or the published messages of two runs differ."""
    return _what_happened(one) != _what_happened(other)


def _what_happened(outcome: Outcome) -> tuple[list[Any], list[Any]]:
    assert outcome.recording is not None
    parameters = [(time_ns, node, name, value) for time_ns, node, name, value, _ in outcome.recording.parameter_rows]
    topics = [row for row in outcome.recording.rows('topics') if row['topic'] not in NOT_COMPARED]
    return parameters, [(row['topic'], row['type'], list(row['messages'])) for row in topics]


def plan_of(outcomes: Sequence[Outcome]) -> Plan:
    """Return, for each run, (arguments to pass, reason or '', arguments with a calculated default).

    The last part is empty for a run that needs arguments.
    """
    recorded = [outcome.recording for outcome in outcomes if outcome.recording is not None]
    if not recorded:
        return [({}, '', {}) for _ in outcomes]
    known = described_defaults(recorded[0])
    given = [_to_give(outcome, known) if outcome.scenario.defaults else {} for outcome in outcomes]
    return [
        (names, _why(outcome), {}) if names else ({}, '', _calculated(outcome))
        for names, outcome in zip(given, outcomes, strict=True)
    ]


def keeps_all(plan: Plan) -> bool:
    """Return whether a plan neither repeats a run nor leaves one out."""
    return not any(names or calculated for names, _, calculated in plan)


def _why(outcome: Outcome) -> str:
    return outcome.text if outcome.recording is None else _death(outcome) or ''


def _to_give(outcome: Outcome, known: Mapping[str, str | None]) -> dict[str, str | None]:
    """Return the arguments that the repeated run needs, with their values. Return {} if the run needs no repetition.

    :param known: the defaults that the recording of another run contains.
    """
    defaults = outcome.scenario.defaults
    if outcome.recording is None and outcome.kind != 'unusable':
        return {}
    declared = known if outcome.recording is None else described_defaults(outcome.recording)
    other: dict[str, str | None] = {
        name: wanted for name, wanted in defaults.items() if wanted is not None and _is_other(declared.get(name), wanted)
    }
    if outcome.recording is not None:  # it does not need arguments that it does not declare
        return other or _of_another_type(outcome, declared)
    lacking = {name: wanted for name, wanted in defaults.items() if declared.get(name) is None}
    return {**lacking, **other} or {name: wanted or written_text(declared[name] or '') for name, wanted in defaults.items()}


def _of_another_type(outcome: Outcome, declared: Mapping[str, str | None]) -> dict[str, str | None]:
    """Return the expected defaults that are written in another way, such as 1.0 for 1, if a program died. Otherwise, return {}.

    The type of the default may have caused the death.
    """
    if outcome.recording is None or _death(outcome) is None:
        return {}
    texts = {name: written_text(text) for name, text in declared.items() if text is not None}
    defaults = outcome.scenario.defaults
    return {name: wanted for name, wanted in defaults.items() if wanted is not None and texts.get(name, wanted) != wanted}


def _death(outcome: Outcome) -> str | None:
    """Return a sentence about the first program that died in a run, or None."""
    found = None if outcome.recording is None else next(deaths(outcome.recording), None)
    return None if found is None else f'{found.name} died'


def _is_other(seen: str | None, wanted: str) -> bool:
    return seen is not None and is_literal(seen) and not is_same_value(written_text(seen), wanted)


def _giving(scenario: Scenario, names: Mapping[str, str | None]) -> Scenario:
    rest = {name: default for name, default in scenario.defaults.items() if name not in names}
    return scenario._replace(arguments={**scenario.arguments, **{key: str(value) for key, value in names.items()}}, defaults=rest)
