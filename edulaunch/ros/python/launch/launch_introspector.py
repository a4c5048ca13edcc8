"""Launch descriptions as text."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from .actions.emit_event import EmitEvent
from .actions.execute_process import ExecuteProcess
from .actions.log_info import LogInfo
from .actions.register_event_handler import RegisterEventHandler
from .launch_description import LaunchDescription
from .substitution import Substitution
from .utilities.texts import normalize_to_list_of_substitutions


class LaunchIntrospector:
    """Shows the content of a launch description without executing it."""

    def format_launch_description(self, launch_description: LaunchDescription) -> str:
        """Return the description and its entities as a tree; `ros2 launch -p` prints it."""
        return '\n'.join([f'{launch_description}', *_tree(format_entities(launch_description.entities))])


def format_entities(entities: Iterable[Any]) -> list[list[str]]:
    """Return the lines for each entity. The first line describes the entity, and the lines below it describe its sub-entities."""
    return [[_describe_action(entity), *_lines_below(entity)] for entity in entities]


def _tree(blocks: list[list[str]]) -> list[str]:
    lines = []
    for position, (first, *below) in enumerate(blocks):
        last = position == len(blocks) - 1
        lines.append(f'{"└── " if last else "├── "}{first}')
        lines += [f'{"    " if last else "│   "}{line}' for line in below]
    return lines


def _lines_below(entity: Any) -> list[str]:
    if isinstance(entity, RegisterEventHandler):
        text, entities = entity.event_handler.describe()
        return _tree([[text, *_tree(format_entities(entities))]])
    return []


def _describe_action(entity: Any) -> str:
    if isinstance(entity, LogInfo):
        return f'LogInfo({_describe(entity.msg)})'
    if isinstance(entity, EmitEvent):
        return f"EmitEvent(event='{entity.event.name}')"
    if isinstance(entity, ExecuteProcess):
        return _describe_process(entity)
    if isinstance(entity, RegisterEventHandler):
        return f"RegisterEventHandler('{entity.event_handler}'):"
    return f"Action('{entity}')"


def _describe_process(action: ExecuteProcess) -> str:
    words = ', '.join(_describe(word) for word in action.cmd)
    cwd = 'None' if action.cwd is None else f"'{_describe(action.cwd)}'"
    variables: Any = action.env
    env = (
        None
        if variables is None
        else '{' + ', '.join(f'{_describe(name)}: {_describe(value)}' for name, value in variables) + '}'
    )
    return f'ExecuteProcess(cmd=[{words}], cwd={cwd}, env={env}, shell={action.shell})'


def _describe(substitutions: Any) -> str:
    known: list[Substitution] = normalize_to_list_of_substitutions(substitutions)
    return ' + '.join(part.describe() for part in known)
