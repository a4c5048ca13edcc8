"""The Tab key: what could stand at the end of an unfinished `ros2` line on a machine that lives."""

from __future__ import annotations

from typing import TYPE_CHECKING

from edulaunch.attached import attached

if TYPE_CHECKING:
    from edulaunch.session import Session


def completions(session: Session, words: list[str], typed: str) -> list[str]:
    """Words that could come behind `ros2 WORDS...` and begin as what is typed, in alphabetical order."""
    possible = attached('completions')(words, typed, lambda: session.index, lambda command: _listed(session, command))
    return sorted({word for word in possible if word.startswith(typed)})


def _listed(session: Session, command: str) -> list[str]:
    """What a command such as `topic list` would print now, without a turn of anybody's."""
    rows, (what, *rest) = session.recorder.endpoints, command.split()
    if what == 'node':
        return [node.fully_qualified_name for node in session.graph.nodes if not node.name.startswith('_')]
    if what == 'param':
        return [row[2] for row in session.recorder.parameters if row[1] == rest[-1]]
    if what == 'topic' and rest[0] == 'type':
        return [row[2] for row in rows if row[1] == rest[-1]]
    if what == 'interface':
        from edulaunch.interfaces import current_registry

        kinds = {'-m': 'msg', '-s': 'srv', '-a': 'action'}
        return current_registry().types(next((kinds[word] for word in rest if word in kinds), None))
    kinds_of = {'topic': ('publisher', 'subscription'), 'service': ('service',), 'action': ('service',)}.get(what, ())
    names = [row[1] for row in rows if row[0] in kinds_of]
    if what == 'action':
        return [name.removesuffix('/_action/send_goal') for name in names if name.endswith('/_action/send_goal')]
    return [name for name in names if '/_action/' not in name]
