"""What an action wants of its process, besides the command line."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from ..utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from ..utilities.type_utils import is_substitution, perform_typed_substitution

if TYPE_CHECKING:
    from ..launch_context import LaunchContext

DEFAULT_OUTPUT_FORMAT = '[{this.process_description.final_name}] {line}'


class ProcessOptions(NamedTuple):
    """As in :class:`launch.actions.ExecuteLocal`; frontends may give substitutions for all but texts."""

    shell: Any = False
    emulate_tty: Any = False
    output_format: str = DEFAULT_OUTPUT_FORMAT
    cached_output: bool = False
    log_cmd: bool = False
    respawn: Any = False
    respawn_delay: Any = None
    respawn_max_retries: Any = -1

    @property
    def are_plain(self) -> bool:
        """Whether no substitution is left."""
        return (
            self.respawn is False
            and self.respawn_delay is None
            and self.respawn_max_retries == -1
            and self.shell.__class__ is bool
            and self.emulate_tty.__class__ is bool
        )

    def performed(self, context: LaunchContext) -> ProcessOptions:
        """The same with all substitutions evaluated.

        :raises ValueError: when a text is not of the type that is needed.
        """
        return self._replace(
            shell=_performed(context, self.shell, bool),
            emulate_tty=_performed(context, self.emulate_tty, bool),
            respawn=perform_typed_substitution(context, self.respawn, bool),
            respawn_delay=_performed(context, self.respawn_delay, float),
            respawn_max_retries=_performed(context, self.respawn_max_retries, int),
        )


def _performed(context: LaunchContext, value: Any, data_type: type) -> Any:
    """A value that frontends may give as substitutions; anything else as it is."""
    if value is None or isinstance(value, (int, float)) or not is_substitution(value):
        return value
    return perform_typed_substitution(context, normalize_to_list_of_substitutions(value), data_type)
