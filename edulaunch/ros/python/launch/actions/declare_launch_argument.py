"""The action `DeclareLaunchArgument`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, ClassVar, NoReturn

from .._bases import ReadOnly
from .._run_notes import note_declared
from ..action import Action
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class DeclareLaunchArgument(Action):
    """Declare a launch argument. Users set it with `ros2 launch ... name:=value`, and includes set it with `launch_arguments`.

    The value of the argument is the launch configuration with the same name. If this configuration is already set, it does not
    change. Otherwise, it is set to the default.

    :param name: a plain string.
    :param default_value: a string or substitutions (so '3', not 3). Without a default, the argument is required.
    :param description: the explanation that `ros2 launch -s` shows.
    :param choices: the only allowed values.
    :raises RuntimeError: for empty `choices`, or a literal default that is not among them.
    """

    _search_role: ClassVar[str] = 'argument'

    def __init__(
        self,
        name: str,
        *,
        default_value: SomeSubstitutionsType | None = None,
        description: str | None = None,
        choices: Iterable[str] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__name = name
        self.__choices = None if choices is None else list(choices)
        if self.__choices is not None:
            _check_choices(self.__choices, default_value)
        self.__default_value = None if default_value is None else normalize_to_list_of_substitutions(default_value)
        self.__description = _describe(description, self.__choices)
        self._conditionally_included = False

    name: ReadOnly[str] = ReadOnly('The name of the launch argument.')
    default_value: ReadOnly[list[Substitution] | None] = ReadOnly('The default, as substitutions, or None.')
    description: ReadOnly[str] = ReadOnly('The explanation that `ros2 launch -s` shows, with the choices.')
    choices: ReadOnly[list[str] | None] = ReadOnly('The only allowed values; None allows any value.')

    def execute(self, context: LaunchContext) -> None:
        """Set the launch configuration to the default if it is not set, and check the choices.

        :raises RuntimeError: when there is neither a value nor a default, or the value is not allowed.
        """
        note_declared(self)
        values = context.launch_configurations
        if self.__name not in values:
            if self.__default_value is None:
                _log_error(f'Required launch argument "{self.__name}" (description: "{self.__description}") was not provided')
                raise RuntimeError(f'Required launch argument "{self.__name}" was not provided.')
            values[self.__name] = perform_substitutions(context, self.__default_value)
        if self.__choices is not None and values[self.__name] not in self.__choices:
            message = f'Argument "{self.__name}" provided value "{values[self.__name]}"'
            _refuse(f'{message} is not valid. Valid options are: {self.__choices}')


def _log_error(message: str) -> None:
    from ..logging import get_logger

    get_logger(__name__).error(message)


def _refuse(message: str) -> NoReturn:
    _log_error(message)
    raise RuntimeError(message)


def _check_choices(choices: list[str], default_value: object) -> None:
    if not choices:
        _refuse('Provided choices arg is empty. Use None to ignore the choice list.')
    if isinstance(default_value, str) and default_value not in choices:
        _refuse(f'Provided default_value "{default_value}" is not in provided choices "{choices}".')


def _describe(description: str | None, choices: list[str] | None) -> str:
    if description is None:
        return 'no description given' if choices is None else f'One of: {choices}'
    if choices is None:
        return description
    stop = '' if description.endswith('.') else '.'
    return f'{description}{stop} Valid choices are: {choices}'
