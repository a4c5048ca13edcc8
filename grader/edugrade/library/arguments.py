"""Checks of the launch arguments that a launch file declares."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from ..evidence import Evidence, Failure, Mismatch, Missing, written_text
from .written import declaration_of, default_of, written

if TYPE_CHECKING:
    from edulaunch.engine.recording.records import DeclaredArgument


def require_declared(run: Evidence, name: str, example: str) -> DeclaredArgument:
    """Return the declaration of a launch argument, with or without a default.

    :param example: a default value for the advice.
    :raises Missing: if the argument is not declared.
    """
    declared = {argument.name: argument for argument in run.first.launch.declared}
    argument = declared.get(name)
    if argument is None:
        raise Missing(
            f'the launch argument "{name}"',
            name=name,
            among=declared,
            expected=written(run, f'a DeclareLaunchArgument named {name}', f'an arg named {name}', f'an arg named {name}'),
            where=run.source.place,
            try_=f'add {declaration_of(run, name, example)}',
        )
    return argument


def require_argument(run: Evidence, name: str, example: str) -> DeclaredArgument:
    """Return the declaration of a launch argument that has a default.

    :param example: a default value for the advice.
    :raises Missing: if the argument is not declared, or has no default.
    """
    argument = require_declared(run, name, example)
    if argument.default is None:
        raise Missing(
            f'the default value of "{name}"',
            expected=default_of(run, example),
            seen='none',
            where=_place(argument),
            try_=f'add a default value to {name}, so that the file can also be launched without arguments',
        )
    return argument


def require_default(
    run: Evidence, name: str, default: str | None, shows: Callable[[Evidence], object] | None = None
) -> DeclaredArgument:
    """Require a default of a launch argument, and return the declaration. The default must be the same string or the same number.

    The runs that do not pass the argument (`Scenario.defaults`) must start without it and use the default.

    :param default: the expected default, or None for any default.
    :param shows: a function that raises Failure if the runs in its evidence do not use the default, or None.
    :raises Missing: as in :func:`require_argument`.
    :raises Mismatch: if the argument has another default.
    :raises Failure: if the runs without the argument fail, or do not use the declared default.
    """
    argument = require_argument(run, name, default or '...')
    seen = written_text(argument.default or '')
    bare = [scenario for scenario in run if name in run.scenario(scenario).defaults]
    is_given = any(name in names for _, names in run.bare.values())  # the runs without this argument were different runs
    is_shown = shows is not None and bare and not is_literal(argument.default or '') and not is_given
    if default is not None and not is_same_value(seen, default) and not is_shown:
        advice = f'write {default_of(run, default)}'
        raise Mismatch(f'the default value of "{name}"', default, seen, where=_place(argument), try_=advice)
    for scenario in [scenario for scenario in run if name in run.bare.get(scenario, ('', ()))[1]]:
        raise Failure(
            f'the launch file does not run without {name}:=...',
            expected='a run without arguments',
            seen=run.bare[scenario][0],
            where=_place(argument),
            try_='launch it without arguments: ros2 launch prints what is missing',
        )
    if shows is not None and bare:
        try:
            shows(run.only(bare))
        except Failure as failure:
            if failure.share:  # a value that is nearly right loses only its own points
                return argument
            raise Failure(
                f'without {name}:=..., the launch file does not use the default value: {failure.rationale}',
                expected=failure.expected,
                seen=failure.seen,
                where=failure.where,
                try_=failure.try_,
            ) from None
    return argument


def is_literal(described: str) -> bool:
    """Return whether a description is that of a string. The value of any other substitution is known only in a run."""
    return len(described) >= 2 and described[0] == described[-1] == "'"


def is_same_value(seen: str, wanted: str) -> bool:
    """Return whether two values of an argument are the same string or represent the same number."""
    try:
        return seen == wanted or float(seen) == float(wanted)
    except ValueError:
        return False


def _place(argument: DeclaredArgument) -> tuple[str, int | None] | None:
    return None if argument.file is None else (argument.file, argument.line)
