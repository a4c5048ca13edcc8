"""The substitution `Command`."""

from __future__ import annotations

import shlex
from typing import TYPE_CHECKING

from edulaunch.engine.facts import with_facts

from .._absent_packages import is_empty_output
from .._bases import ReadOnly
from .._engine import run_command
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from .find_executable import near_program
from .substitution_failure import SubstitutionFailure
from .text_substitution import describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class Command(Substitution):
    """The output of a command, including its last newline. The command line is split as in a shell, but no shell runs.

    :param on_stderr: how to treat output on standard error: 'fail', 'ignore', 'warn', or 'capture' (add it to the result).
    :raises SubstitutionFailure: on evaluation, when the command is missing, fails, or prints to standard error with 'fail'.
    """

    def __init__(self, command: SomeSubstitutionsType, *, on_stderr: SomeSubstitutionsType = 'fail') -> None:
        self.__command = normalize_to_list_of_substitutions(command)
        self.__on_stderr = normalize_to_list_of_substitutions(on_stderr)

    command: ReadOnly[list[Substitution]] = ReadOnly('The command, as substitutions.')
    on_stderr: ReadOnly[list[Substitution]] = ReadOnly('How to treat output on standard error, as substitutions.')

    def describe(self) -> str:
        """Return a description such as `Command('ls')`."""
        return f'Command({describe_all(self.__command)})'

    def perform(self, context: LaunchContext) -> str:
        """Run the command until it ends, and return its output."""
        command = perform_substitutions(context, self.__command)
        on_stderr = perform_substitutions(context, self.__on_stderr)
        if on_stderr not in ('fail', 'ignore', 'warn', 'capture'):
            raise SubstitutionFailure("expected 'on_stderr' to be one of: 'fail', 'ignore', 'warn' or 'capture'")
        try:
            argv = shlex.split(command)
            if is_empty_output(argv):
                return ''
            code, output, errors = run_command(argv, stderr_to_stdout=on_stderr == 'capture')
        except FileNotFoundError as error:
            failure = SubstitutionFailure(f'file not found: {error}')
            raise with_facts(failure, 'launch.program-absent', program=argv[0], near=near_program(argv[0])) from error
        if code != 0:
            captured = f'\nCaptured stderr output: {errors}' if errors else ''
            raise SubstitutionFailure(f'executed command failed. Command: {command}{captured}')
        if errors:
            message = f'executed command showed stderr output. Command: {command}'
            _report(f'{message}\nCaptured stderr output:\n{errors}', on_stderr)
        return output


def _report(message: str, on_stderr: str) -> None:
    if on_stderr == 'fail':
        raise SubstitutionFailure(message)
    if on_stderr == 'warn':
        from ..logging import get_logger

        get_logger().warning(message)
