"""The event handler `StdoutReadyListener`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.event_handlers.on_process_io import OnProcessIO
from launch.events.process.process_io import ProcessIO
from launch.launch_description_entity import LaunchDescriptionEntity


class StdoutReadyListener(OnProcessIO):
    """Visit `actions` when a program has written `ready_txt` to its standard output.

    :param target_action: the action of the program; None means any program.
    :param ready_txt: the string to wait for; it may arrive in pieces.
    :param actions: the actions, which are visited only once.
    """

    def __init__(self, *, target_action: Any = None, ready_txt: str, actions: Iterable[LaunchDescriptionEntity]) -> None:
        self.__ready_txt = ready_txt
        self.__actions = list(actions)
        self.__received: dict[str, str] = {}
        super().__init__(target_action=target_action, on_stdout=self.__on_stdout)

    def __on_stdout(self, event: ProcessIO) -> list[LaunchDescriptionEntity] | None:
        text = self.__received.get(event.process_name, '') + event.text.decode(errors='replace')
        self.__received[event.process_name] = text
        if self.__ready_txt not in text:
            return None
        actions, self.__actions = self.__actions, []
        return actions or None
