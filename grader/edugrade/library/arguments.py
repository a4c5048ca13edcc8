"""Launch arguments as the launch file declares them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..evidence import Evidence, Mismatch, Missing

if TYPE_CHECKING:
    from edulaunch.engine.recording.records import DeclaredArgument

_JOINT = "' + '"  # between the parts of a text, as `ros2 launch --show-args` prints them


def require_declared(run: Evidence, name: str, example: str) -> DeclaredArgument:
    """Return the declaration of a launch argument, with a default or without one.

    :param example: a default value for the advice.
    :raises Missing: when it is not declared.
    """
    declared = {argument.name: argument for argument in run.first.launch.declared}
    argument = declared.get(name)
    if argument is None:
        raise Missing(
            f'the launch argument "{name}"',
            name=name,
            among=declared,
            expected=f'a DeclareLaunchArgument named {name}',
            where=run.source.place,
            try_=f"add DeclareLaunchArgument('{name}', default_value='{example}', description='...')",
        )
    return argument


def require_argument(run: Evidence, name: str, example: str) -> DeclaredArgument:
    """Return the declaration of a launch argument that has a default.

    :param example: a default value for the advice.
    :raises Missing: when it is not declared, or has no default.
    """
    argument = require_declared(run, name, example)
    if argument.default is None:
        raise Missing(
            f'the default value of "{name}"',
            expected=f"default_value='{example}'",
            seen='none',
            where=_place(argument),
            try_='give it a default_value, so that the file can be launched without arguments too',
        )
    return argument


def require_default(run: Evidence, name: str, default: str) -> None:
    """A launch argument has a certain default: the same text, in one part or several, or the same number.

    :raises Missing: as :func:`require_argument`.
    :raises Mismatch: when it has another default.
    """
    argument = require_argument(run, name, default)
    seen = written_text(argument.default or '')
    if not (seen == default or _is_same_number(seen, default)):
        raise Mismatch(
            f'the default value of "{name}"', default, seen, where=_place(argument), try_=f"write default_value='{default}'"
        )


def written_text(described: str) -> str:
    """The text behind a description such as ``'1' + '.0'``; another substitution stays as it is described."""
    if len(described) >= 2 and described[0] == described[-1] == "'":
        return described[1:-1].replace(_JOINT, '')
    return described


def _is_same_number(seen: str, wanted: str) -> bool:
    try:
        return float(seen) == float(wanted)
    except ValueError:
        return False


def _place(argument: DeclaredArgument) -> tuple[str, int | None] | None:
    return None if argument.file is None else (argument.file, argument.line)
