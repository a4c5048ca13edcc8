"""Parameter files that give a node nothing."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.outlines import name_of, nodes, place_of
from edulaunch.advice.rule import rule
from edulaunch.nearest import nearest

if TYPE_CHECKING:
    from edulaunch.plan import Rehearsal

LESSON = '05_large_project'


@rule(
    'launch.key-for-no-node',
    what='{file} gives {node} nothing: its keys are {keys}',
    why='a parameter file is read by full node names; a key that names another node is passed over in silence',
    do=(
        'write {node}: (or /**: for any node) in place of {near}:',
        'write {node}: (or /**: for any node) above ros__parameters:',
    ),
    lesson=LESSON,
    level='error',
)
def key_for_no_node(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Of a node whose name the launch file says, and a file of which no key means it."""
    from edulaunch.graph.parameters import pattern_matches
    from edulaunch.graph.ros_arguments import entries_of_file

    for _, item in nodes(rehearsal):
        for source in item['parameter_sources']:
            if item['runtime_name'] is None or not os.path.isfile(source['file']):
                continue
            try:
                entries = entries_of_file(source['file'])
            except (OSError, ValueError):
                continue  # the node says what is wrong
            lines = {entry.pattern: entry.line for entry in reversed(entries)}
            keys = list(lines)[::-1]
            if keys and not any(pattern_matches(key, item['runtime_name']) for key in keys):
                near = nearest(item['runtime_name'], keys) or (keys[0] if len(keys) == 1 else None)
                yield found(
                    'file',
                    os.path.basename(source['file']),
                    file=source['file'],
                    line=max(lines[near or keys[0]] - 2, 1),
                    node=item['runtime_name'],
                    keys=keys[:5],
                    near=near,
                )


@rule(
    'launch.parameter-file-missing',
    what='the parameter file {file} is not there, so {node} starts without it',
    why='launch only writes a warning, and goes on',
    do=(
        'write {near}',
        'install it: add the folder {folder}/ to data_files of setup.py, or to install(DIRECTORY ...) of CMakeLists.txt',
        'make that file, or write the path of the one you mean',
    ),
    lesson=LESSON,
    level='error',
)
def parameter_file_missing(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Not one of a package that is missing altogether; of a relative path another rule tells more."""
    for branch, item in nodes(rehearsal):
        for path in branch.action.missing_parameter_files():
            is_assumed = rehearsal.placeholders is not None and path.startswith(rehearsal.placeholders)
            if os.path.isabs(path) and not is_assumed:
                folder, name = os.path.split(path)
                beside = os.listdir(folder) if os.path.isdir(folder) else []
                is_shared = f'{os.sep}share{os.sep}' in path
                shared = os.path.basename(folder) if is_shared else None
                near = nearest(name, beside)
                yield found('file', name, **place_of(branch), node=name_of(item), near=near, folder=shared)


@rule(
    'launch.parameter-order',
    what='{parameter} of {node} is {value} by {written}, although the launch file gives {lost} behind it',
    why='what stands for /** was met first (by SetParameter or another file), so an entry that names the node counts after it',
    do="give the node its namespace, namespace='/', or take {parameter} out of {written}",
    lesson=LESSON,
)
def parameter_order(rehearsal: Rehearsal) -> Iterator[Finding]:
    """The last one that is given does not count, which hardly anybody expects; by rcl's order of patterns."""
    for branch, item in nodes(rehearsal):
        if not any(os.path.isfile(source['file']) for source in item['parameter_sources']):
            continue
        winners = {one.name: one for one in branch.action.given_parameters()}
        for name, winner in winners.items():
            behind = _given_behind(item, winner.file, name) if winner.is_of_a_file else None
            if behind is not None and behind != winner.value:
                facts = {'node': name_of(item), 'value': winner.value, 'written': os.path.basename(winner.file), 'lost': behind}
                yield found('parameter', name, **place_of(branch), **facts)


def _given_behind(item: dict[str, Any], file: str, parameter: str) -> Any:
    """The value that a dict of the launch file gives behind a parameter file, None when there is none."""
    sources = item['parameter_sources']
    first = next((number for number, source in enumerate(sources) if source['file'] == file), len(sources))
    for source in sources[first + 1 :]:
        content = source['content'] if not os.path.isfile(source['file']) else None
        for given in (content or {}).values():
            if parameter in given.get('ros__parameters', {}):
                return given['ros__parameters'][parameter]
    return None
