"""The action `ExecuteProcess`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from ..descriptions.executable import Executable, Substitutions, Variables
from ..substitution import SomeSubstitutionsType
from .execute_local import ExecuteLocal

if TYPE_CHECKING:
    from ..frontend.parser_protocol import ParserProtocol

Pairs = list[tuple[Substitutions, Substitutions]]


class ExecuteProcess(ExecuteLocal):
    """Run a command. `ros2 ...` and programs of known packages run in the simulation. Any other command runs on the computer.

    :param cmd: the words of the command, each a string or substitutions. If `cmd` is a plain string, each letter becomes a word.
    :param prefix: the words before the command, such as 'xterm -e'. The default is the launch configuration `launch-prefix`.
    :param name: the name of the process in the log, without its number. The default is the file name of the program.
    :param cwd: the working directory. The default is the working directory of launch.
    :param env: the complete environment. The default is the environment of launch.
    :param additional_env: variables to add to the environment.
    :param kwargs: the arguments of :class:`ExecuteLocal`, except `process_description`.
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
        **kwargs: Any,
    ) -> None:
        executable = Executable(cmd=cmd, prefix=prefix, name=name, cwd=cwd, env=env, additional_env=additional_env)
        super().__init__(process_description=executable, **kwargs)

    @classmethod
    def _parse_cmdline(cls, cmd: str, parser: ParserProtocol) -> list[Substitutions]:
        """Return the words of a command line in the form of XML and YAML. Extensions of launch call this method by upstream's
        name.
        """
        from ..frontend.elements import words_of

        return words_of(cmd, parser)

    @property
    def name(self) -> str | Substitutions | None:
        """The unique name. Before execution, this is the given name, as substitutions."""
        description = self.process_description
        return description.final_name if description.final_name is not None else description.name

    @property
    def cmd(self) -> Any:
        """The command line. Before execution, each word is a list of substitutions."""
        description = self.process_description
        return description.final_cmd if description.final_cmd is not None else description.cmd

    @property
    def cwd(self) -> str | Substitutions | None:
        """The working directory. Before execution, it is a list of substitutions."""
        description = self.process_description
        return description.final_cwd if description.final_cwd is not None else description.cwd

    @property
    def env(self) -> dict[str, str] | Pairs | None:
        """The environment. Before execution, its entries are substitutions."""
        description = self.process_description
        return description.final_env if description.final_env is not None else description.env

    @property
    def additional_env(self) -> Pairs | None:
        """The additional environment variables, as substitutions."""
        return self.process_description.additional_env
