"""Launch arguments as the launch file declares them."""

from __future__ import annotations

from ..evidence import Evidence
from ..failure import Mismatch, Missing


def require_argument(run: Evidence, name: str, example: str, default: str | None = None) -> None:
    """A launch argument is declared, with a default.

    :param example: a default value for the advice.
    :param default: the default that is asked for, if it is a certain one.
    :raises Missing: when it is not declared, or has no default.
    :raises Mismatch: when it has another default.
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
    where = None if argument.file is None else (argument.file, argument.line)
    if argument.default is None:
        raise Missing(
            f'the default value of "{name}"',
            expected=f"default_value='{example}'",
            seen='none',
            where=where,
            try_='give it a default_value, so that the file can be launched without arguments too',
        )
    if default is not None and argument.default not in (default, repr(default)):
        raise Mismatch(
            f'the default value of "{name}"', default, argument.default, where=where, try_=f"write default_value='{default}'"
        )
