"""The class `Executable`."""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING

from .._bases import ReadOnly
from .._engine import process_counter
from ..substitution import SomeSubstitutionsType, Substitution
from ..substitutions.launch_configuration import LaunchConfiguration
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..action import Action
    from ..launch_context import LaunchContext


PREFIX = LaunchConfiguration('launch-prefix', default='')


PREFIX_FILTER = LaunchConfiguration('launch-prefix-filter', default='')


Substitutions = list[Substitution]


Word = str | Substitution | Substitutions


Variables = Mapping[SomeSubstitutionsType, SomeSubstitutionsType]


class Executable:
    """A program to run. :meth:`prepare` computes the `final_...` values from the substitutions.

    :param cmd: the words of the command line, each a string or substitutions.
    :param prefix: the words before the command, split as in a shell. The default is the launch configuration `launch-prefix`, for
        programs whose name matches the regular expression in `launch-prefix-filter`.
    :param name: the name of the process without its number. The default is the file name of the program.
    :param cwd: the working directory. The default is the working directory of launch.
    :param env: the complete environment. The default is the environment of launch.
    :param additional_env: variables to add to the environment.
    :param arguments: further words of the command line.
    """

    def __init__(
        self,
        *,
        cmd: Iterable[SomeSubstitutionsType],
        prefix: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        cwd: SomeSubstitutionsType | None = None,
        env: Variables | None = None,
        additional_env: Variables | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
    ) -> None:
        self.__words: list[Word] = []
        self.add_words(cmd)
        self.__arguments = None if arguments is None else list(arguments)
        if arguments is not None:
            self.add_words(self.__arguments or ())
        self.__given_prefix = None if prefix is None else normalize_to_list_of_substitutions(prefix)
        self.__name = None if name is None else normalize_to_list_of_substitutions(name)
        self.__cwd = None if cwd is None else normalize_to_list_of_substitutions(cwd)
        self.__env = None if env is None else _normalize_variables(env)
        self.__additional_env = None if additional_env is None else _normalize_variables(additional_env)
        self.__final_name: str | None = None
        self._command: list[str] | None = None
        self._named_files: Callable[[], object] | None = None
        self.__final_cwd: str | None = None
        self.__final_env: dict[str, str] | None = None

    name: ReadOnly[Substitutions | None] = ReadOnly('The name, as substitutions.')

    @property
    def prefix(self) -> Substitutions:
        """The prefix of the command, such as `gdb --args`, as a list of substitutions."""
        return [PREFIX] if self.__given_prefix is None else self.__given_prefix

    @property
    def cmd(self) -> list[Substitutions]:
        """The words of the command line, as substitutions. Changes of this list change the command."""
        words = self.__words
        words[:] = [word if isinstance(word, list) else normalize_to_list_of_substitutions(word) for word in words]
        return words  # type: ignore[return-value]

    def add_words(self, words: Iterable[SomeSubstitutionsType]) -> None:
        """Append words to the command line. A string becomes a substitution when it is first read."""
        self.__words += [
            word if type(word) is str or isinstance(word, Substitution) else normalize_to_list_of_substitutions(word)
            for word in words
        ]

    cwd: ReadOnly[Substitutions | None] = ReadOnly('The working directory, as substitutions.')
    env: ReadOnly[list[tuple[Substitutions, Substitutions]] | None] = ReadOnly('The environment, as substitutions.')
    additional_env: ReadOnly[list[tuple[Substitutions, Substitutions]] | None] = ReadOnly(
        'The variables to add to the environment, as substitutions.'
    )

    arguments: ReadOnly[list[SomeSubstitutionsType] | None] = ReadOnly('The further words of the command line, as given.')
    final_name: ReadOnly[str | None] = ReadOnly("The unique name, such as 'talker-1'; None before :meth:`prepare`.")

    @property
    def final_cmd(self) -> list[str] | None:
        """The words of the command line, or None before :meth:`prepare`.

        Reading this property writes the generated files that the command names.
        """
        if self._named_files is not None:
            self._named_files()
            self._named_files = None
        return self._command

    @property
    def command(self) -> list[str] | None:
        """The value of :attr:`final_cmd` for callers that do not read the files that the command names. (edulaunch only.)"""
        return self._command

    @property
    def word_count(self) -> int:
        """The number of words of the command line without a prefix. Reading this property creates no substitution. (edulaunch
        only.)
        """
        return len(self.__words)

    def write_before_look(self, write: Callable[[], object]) -> None:
        """Set `write` as the function that creates the files that the command names. It is called on first use. (edulaunch
        only.)
        """
        self._named_files = write

    final_cwd: ReadOnly[str | None] = ReadOnly('The working directory; None means that of launch.')
    final_env: ReadOnly[dict[str, str] | None] = ReadOnly('The environment; None before :meth:`prepare`.')

    def prepare(self, context: LaunchContext, action: Action | None) -> None:
        """Evaluate all substitutions in `context`, and assign the next process number."""
        cmd = [word if isinstance(word, str) else _performed(context, word) for word in self.__words]
        prefix = self.__prefix_words(context, cmd[0])
        self._command = [*prefix, *cmd] if prefix else cmd
        name = os.path.basename(self._command[0]) if self.__name is None else perform_substitutions(context, self.__name)
        counter = process_counter(context)
        counter[0] += 1
        self.__final_name = f'{name}-{counter[0]}'
        self.__final_cwd = None if self.__cwd is None else perform_substitutions(context, self.__cwd)
        self.__final_env = dict(context.environment) if self.__env is None else _perform_variables(context, self.__env)
        if self.__additional_env is not None:
            self.__final_env.update(_perform_variables(context, self.__additional_env))

    def __prefix_words(self, context: LaunchContext, program: str) -> list[str]:
        """Return the prefix of this program. The filter does not apply to a prefix given as the argument `prefix`."""
        if self.__given_prefix is not None:
            return shlex.split(perform_substitutions(context, self.__given_prefix))
        if 'launch-prefix' not in context.launch_configurations:
            return []
        prefix = PREFIX.perform(context)
        if not prefix or re.match(PREFIX_FILTER.perform(context), os.path.basename(program)) is None:
            return []
        return shlex.split(prefix)


def _performed(context: LaunchContext, word: Substitution | Substitutions) -> str:
    return perform_substitutions(context, word) if isinstance(word, list) else word.perform(context)


def _normalize_variables(variables: Variables) -> list[tuple[Substitutions, Substitutions]]:
    return [
        (normalize_to_list_of_substitutions(key), normalize_to_list_of_substitutions(value)) for key, value in variables.items()
    ]


def _perform_variables(context: LaunchContext, variables: Iterable[tuple[Substitutions, Substitutions]]) -> dict[str, str]:
    return {perform_substitutions(context, key): perform_substitutions(context, value) for key, value in variables}
