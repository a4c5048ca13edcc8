"""One line of help for an error in an XML or YAML launch file: where it is, and what was probably meant.

The errors keep ROS's types and texts. What we add hangs on them as attributes, for whoever shows them:
`edulaunch_file`, `edulaunch_line`, `edulaunch_tag`, and `edulaunch_help` with all of it in one line.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Any, TypeVar

from .._origin import origin_of
from .registry import action_parse_methods, substitution_parse_methods

if TYPE_CHECKING:
    from .entity import Entity

Error = TypeVar('Error', bound=BaseException)

_HOMES = {
    # elements that stand inside others: (where, and what does it for everything that follows)
    'param': (('node',), 'set_parameter'),
    'remap': (('node',), 'set_remap'),
    'env': (('node', 'executable'), 'set_env'),
    'choice': (('arg',), None),
    'keep': (('group', 'reset'), None),
    'extra_arg': (('composable_node',), None),
    'composable_node': (('node_container', 'load_composable_node'), None),
}
ROS_1_ELEMENTS = {'rosparam': 'param', 'test': 'node', 'machine': None}
INSTEAD = {
    # (element, what people write there): what it is called; many are names of ROS 1 or of the Python classes
    ('node', 'type'): 'exec',
    ('node', 'ns'): 'namespace',
    ('node', 'required'): 'on_exit',
    ('node', 'executable'): 'exec',
    ('node', 'package'): 'pkg',
    ('node', 'parameters'): 'param',
    ('node', 'arguments'): 'args',
    ('node', 'remappings'): 'remap',
    ('group', 'ns'): '<push_ros_namespace namespace="..."/>',
    ('include', 'ns'): '<push_ros_namespace namespace="..."/> in a <group>',
    ('arg', 'doc'): 'description',
    ('arg', 'value'): 'default',
    ('push_ros_namespace', 'ns'): 'namespace',
    ('include', 'param'): 'arg',
    ('include', 'path'): 'file',
    ('let', 'default'): 'value',
    ('param', 'file'): 'from',
    ('remap', 'name'): 'from',
    ('remap', 'value'): 'to',
    ('set_remap', 'src'): 'from',
    ('set_remap', 'dst'): 'to',
    ('timer', 'delay'): 'period',
    ('timer', 'actions'): 'children',
    ('log', 'msg'): 'message',
    ('log', 'text'): 'message',
    ('executable', 'command'): 'cmd',
    ('set_parameters_from_file', 'file'): 'filename',
}
ROS_1_CALLS = {
    'arg': '$(var ...)',
    'find': '$(find-pkg-share ...)',
    'optenv': '$(env NAME DEFAULT)',
    'any': '$(or ... ...)',
    'all': '$(and ... ...)',
}


def hinted(error: Error, hint: str | None) -> Error:
    """The error, which now says `hint` in addition."""
    if hint is not None:
        error.edulaunch_hint = hint  # type: ignore[attr-defined]
    return error


def at(error: Error, entity: Entity, hint: str | None) -> Error:
    """The error, which now knows its element and says `hint`."""
    error.edulaunch_line = entity.line  # type: ignore[attr-defined]
    error.edulaunch_tag = entity.type_name  # type: ignore[attr-defined]
    error.edulaunch_shown = entity.shown  # type: ignore[attr-defined]
    return hinted(error, hint)


def complete(error: BaseException, file: str, entity: Entity) -> None:
    """For an `error` on its way out of `entity`: add what is still missing; the innermost element wins."""
    known: Any = error
    if hasattr(error, 'edulaunch_help'):
        return
    if not hasattr(error, 'edulaunch_line'):
        at(error, entity, getattr(error, 'edulaunch_hint', None))
    known.edulaunch_file = file
    _point_to(error, file, known.edulaunch_line)
    hint = getattr(error, 'edulaunch_hint', None) or f'in {known.edulaunch_shown}'
    known.edulaunch_help = f'{file or "<string>"}:{known.edulaunch_line}: {hint}'


def about_element(entity: Entity) -> str:
    """For an element that no action has."""
    name = str(entity.type_name)
    if name in ROS_1_ELEMENTS:
        instead = ROS_1_ELEMENTS[name]
        tail = f"; '{instead}' does this in ROS 2" if instead else '; ROS 2 has nothing like it'
        return f'{entity.shown} is an element of ROS 1{tail}'
    if name in _HOMES:
        places, for_all = _HOMES[name]
        inside = ' or '.join(entity.shown.replace(name, place) for place in places)
        return f'{entity.shown} stands inside {inside}' + (
            f'; for everything that follows there is {entity.shown.replace(name, for_all)}' if for_all else ''
        )
    near = _nearest(name, action_parse_methods)
    meant = entity.shown.replace(name, near) if near else None
    return f'{entity.shown} is no launch element' + (f'; did you mean {meant}?' if meant else '')


def about_name(name: str, entity: Entity, known: Collection[str]) -> str:
    """For an attribute or child that the element does not have."""
    instead = _instead(entity, name)
    near = instead or _nearest(str(name), known)
    shown = near if near is None or near.startswith('<') else f"'{near}'"
    return f"{entity.shown} knows no '{name}'" + (f'; did you mean {shown}?' if shown else '')


def _instead(entity: Entity, name: str) -> str | None:
    return INSTEAD.get((str(entity.type_name).replace('-', '_'), name))


def about_call(name: str) -> str | None:
    """For a `$(name ...)` that is unknown or has the wrong arguments."""
    if name in ROS_1_CALLS:
        return f'write {ROS_1_CALLS[name]} instead of $({name} ...)'
    if name == 'eval':
        return "put the whole expression into quotes: $(eval '...')"
    if name in substitution_parse_methods:
        return f'look at the arguments of $({name} ...): one space before each, quotes where it has spaces'
    near = _nearest(name, substitution_parse_methods)
    return f'$({name} ...) is no substitution' + (f'; did you mean $({near} ...)?' if near else '')


def nearest_given(name: str, entity: Entity, names: Any) -> str | None:
    """Which of the `names` that an element has is probably meant for `name`, which it needs."""
    given = [one for one in names if isinstance(one, str)]
    return next((one for one in given if _instead(entity, one) == name), None) or _nearest(name, given)


def _nearest(name: str, names: Any) -> str | None:
    from edulaunch.nearest import nearest

    return nearest(name, names)


def complete_unreadable(error: Any, file: str) -> None:
    """For the error of a text that is not in its format: add the place and the problem."""
    mark = getattr(error, 'problem_mark', None)
    line = getattr(error, 'edulaunch_line', 0) or (mark.line + 1 if mark is not None else _first_or_bad_line(error))
    problem = getattr(error, 'edulaunch_hint', None) or getattr(error, 'problem', None) or str(error)
    first_line = problem.split('\n', 1)[0]
    if isinstance(error, UnicodeDecodeError):
        hinted(error, 'save the file as UTF-8')
    error.edulaunch_file, error.edulaunch_line = file, line
    _point_to(error, file, line)
    error.edulaunch_help = f'{file or "<string>"}:{line}: {first_line}'


def _first_or_bad_line(error: Exception) -> int:
    """Where a byte is that is no UTF-8; any other problem is one of the whole text, which begins at line 1."""
    return error.object.count(b'\n', 0, error.start) + 1 if isinstance(error, UnicodeDecodeError) else 1


def _point_to(error: Any, file: str, line: int) -> None:
    """The same place as an error of a Python launch file has it (see `launch._origin`)."""
    if file and not hasattr(error, 'edulaunch_origin'):
        error.edulaunch_origin = origin_of((file, line))
