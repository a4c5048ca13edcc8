"""What an action wants of its process, besides the command line."""

from __future__ import annotations

from typing import Any, NamedTuple

DEFAULT_OUTPUT_FORMAT = '[{this.process_description.final_name}] {line}'


class ProcessOptions(NamedTuple):
    """As in :class:`launch.actions.ExecuteLocal`. Only `respawn` may be substitutions, until the action is prepared: as upstream
    the others are used as they are given.
    """

    shell: Any = False
    emulate_tty: Any = False
    output_format: str = DEFAULT_OUTPUT_FORMAT
    cached_output: bool = False
    log_cmd: bool = False
    respawn: Any = False
    respawn_delay: Any = None
    respawn_max_retries: Any = -1

    def wants_respawn(self, retries: int) -> bool:
        """Whether a process that has ended is to be started again.

        :param retries: how often it was already.
        :raises TypeError: when the number of retries is none.
        """
        return bool(self.respawn) and (self.respawn_max_retries < 0 or retries < self.respawn_max_retries)

    @property
    def has_delay(self) -> bool:
        """Whether that is to be later.

        :raises TypeError: when the delay is no number.
        """
        return self.respawn_delay is not None and bool(self.respawn_delay > 0.0)
