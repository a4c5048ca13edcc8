"""Rules about parameter files without an effect, and about paths that exist only in one folder or on one computer."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.outlines import branches, launch_files, name_of, nodes, place_of
from edulaunch.advice.rule import Finding, found, rule
from edulaunch.engine.nearest import nearest_file, nearest_spelling

if TYPE_CHECKING:
    from edulaunch.advice.plan import Rehearsal

LESSON = '03_parameters'


@rule(
    'launch.key-for-no-node',
    what=(
        '{file} sets no parameter of {nodes}, because its only key is {only}',
        '{file} sets no parameter of {nodes}, because its keys are {keys}',
    ),
    why='ROS 2 compares each key of a parameter file with the full name of the node, and ignores other keys silently',
    do=(
        'replace the key `{near}` with `{node}` (or with `/**` for all nodes)',
        'write the key `{node}` (or `/**` for all nodes) above `ros__parameters`',
    ),
    lesson=LESSON,
    level='error',
    hides=('programs.key-for-no-node',),
)
def key_for_no_node(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a parameter file that has no key for the node. The launch file must give the node a name."""
    from edulaunch.engine.graph.parameters import pattern_matches
    from edulaunch.engine.graph.ros_arguments import entries_of_file

    names = [item['runtime_name'] for _, item in nodes(rehearsal) if item['runtime_name']]
    for _, item in nodes(rehearsal):
        for source in item['parameter_sources']:
            if item['runtime_name'] is None or is_container(item['executable']) or not os.path.isfile(source['file']):
                continue
            try:
                entries = entries_of_file(source['file'])
            except (OSError, ValueError):
                continue  # the node itself reports the mistake
            lines = {entry.pattern: entry.line for entry in reversed(entries)}
            keys = list(lines)[::-1]
            if keys and not any(pattern_matches(key, item['runtime_name']) for key in keys):
                free = [key for key in keys if not any(pattern_matches(key, name) for name in names)]
                if not free:
                    continue  # the file is meant for other nodes of the launch file
                near = nearest_spelling(item['runtime_name'], free) or (keys[0] if len(keys) == 1 else None)
                yield found(
                    'file',
                    os.path.basename(source['file']),
                    file=os.path.realpath(source['file']),
                    line=max(lines[near or keys[0]] - 2, 1),
                    node=item['runtime_name'],
                    nodes=item['runtime_name'],
                    only=keys[0] if len(keys) == 1 else None,
                    keys=keys[:5],
                    near=near,
                )


def _in_sources(path: str) -> str:
    """Return the path of a share file in the sources of its package, if the installed package.xml is a link to the sources."""
    head, _, tail = path.rpartition(f'{os.sep}share{os.sep}')
    package, _, name = tail.partition(os.sep)
    manifest = os.path.realpath(os.path.join(head, 'share', package, 'package.xml'))
    return os.path.join(os.path.dirname(manifest), name)


def is_container(executable: str) -> bool:
    """Return whether a program is a component container, which passes its parameter files to the nodes that it loads."""
    return executable.startswith('component_container')


@rule(
    'launch.parameter-file-missing',
    what='the parameter file {file} does not exist, so {node} starts without it',
    why='launch only prints a warning, and continues',
    do=(
        'write {near}',
        'add the folder {folder}/ to data_files in setup.py, or to install(DIRECTORY ...) in CMakeLists.txt',
        'create that file, or write the path of the file that you mean',
    ),
    lesson=LESSON,
    level='error',
    hides=('launch.parameter-file-absent',),
)
def parameter_file_missing(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a missing parameter file. Skip files of missing packages, and files that the launch file writes.

    Another rule reports relative paths.
    """
    written = rehearsal.plan.get('not_done', ())
    for branch, item in nodes(rehearsal):
        for path in branch.action.missing_parameter_files():
            is_assumed = rehearsal.placeholders is not None and path.startswith(rehearsal.placeholders)
            if os.path.isabs(path) and not is_assumed and f'write {path}' not in written:
                folder, name = os.path.split(path)
                beside = os.listdir(folder) if os.path.isdir(folder) else []
                is_shared = f'{os.sep}share{os.sep}' in path
                is_written = is_shared and os.path.isfile(_in_sources(path))
                shared = os.path.basename(folder) if is_written else None
                near = nearest_file(name, beside)
                yield found('file', name, **place_of(branch), node=name_of(item), near=near, folder=shared)


@rule(
    'launch.parameter-order',
    what='{parameter} of {node} gets the value {value} from {written}, although the launch file sets {lost} later',
    why='there is an earlier entry for /**, so the entry for {node} in {written} overrides all later entries for /**',
    do="set the namespace of the node with namespace='/', or remove {parameter} from {written}",
    lesson=LESSON,
)
def parameter_order(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a parameter value that comes last and still has no effect, because rcl sorts the patterns of node names."""
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
    """Return the value that a dictionary sets after a parameter file, or None."""
    sources = item['parameter_sources']
    first = next((number for number, source in enumerate(sources) if source['file'] == file), len(sources))
    for source in sources[first + 1 :]:
        content = source['content'] if not os.path.isfile(source['file']) else None
        for section in (content or {}).values():
            if parameter in section.get('ros__parameters', {}):
                return section['ros__parameters'][parameter]
    return None


DO = (
    'write $(dirname)/{xml}, or $(find-pkg-share my_package)/... for a file in a package',
    "write os.path.join(os.path.dirname(__file__), '{path}'), or use a path in the share folder of your package",
)


@rule(
    'launch.relative-path',
    what='launch looks for {path} in the folder where you start it, not next to the launch file',
    why='launch finds the file only if every user starts it from that folder',
    do=DO,
    lesson=LESSON,
    hides=('launch.parameter-file-absent',),
)
def relative_path(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a relative path of an included launch file or a parameter file."""
    for branch in branches(rehearsal):
        if branch.item is not None and branch.item['kind'] == 'include' and branch.origin is not None:
            location = branch.action.launch_description_source.location
            if not os.path.isabs(location) and os.path.isfile(location):
                yield _of_path(location, place_of(branch))
    for branch, item in nodes(rehearsal):
        paths = [source['file'] for source in item['parameter_sources']]
        for path in (*paths, *branch.action.missing_parameter_files()):
            if not os.path.isabs(path):
                yield _of_path(path, place_of(branch))


def _of_path(path: str, place: dict[str, Any]) -> Finding:
    is_python = str(place.get('file', '')).endswith('.py')
    return found('path', path, **place, xml=None if is_python else path)


_HOME = re.compile(r"""['"](/(?:home|Users)/[\w.-]+/[^'"\n]*)['"]""")
_DEFAULT = re.compile(r'\bdefault(_value)?\s*[=:]\s*$')


@rule(
    'launch.path-of-one-machine',
    what='the absolute path {path} exists on only one computer',
    why='other users have different home folders',
    do=(
        "find the file by its package: PathJoinSubstitution([FindPackageShare('{package}'), {parts}])",
        "let the build install {unbuilt}, and find it by its package with FindPackageShare('{package}')",
        'replace the default {default} with a file of a package, found with FindPackageShare, or give the argument no default',
        'make the path a launch argument, or move the file into a package and find it with FindPackageShare',
    ),
    lesson=LESSON,
    level='info',
    confidence='asked',
)
def path_of_one_machine(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a literal path into a home folder."""
    from edulaunch.engine.underlay_place import is_students
    from edulaunch.ros.sources.source_package import read_text

    for file in filter(is_students, launch_files(rehearsal)):
        for number, line in enumerate(read_text(file).splitlines(), 1):
            written = _HOME.search(line)
            if written is not None and not line.lstrip().startswith('#'):
                default = written[1] if _DEFAULT.search(line[: written.start()]) else None
                yield found('path', written[1], file=file, line=number, default=default, **_in_package(file, written[1]))


def _in_package(file: str, path: str) -> dict[str, Any]:
    """Return facts about a path such as `src/PACKAGE/config/a.yaml`: the package, and the place where a build installs the file.

    If the package is not in the workspace of the launch file, assume that a build installs the same folders. If a build does not
    install the file, the fact `unbuilt` names it.
    """
    from edulaunch.engine.packages import Index
    from edulaunch.engine.packages.discovery import find_workspaces, install_folders
    from edulaunch.ros.sources import read_source

    matched = re.search(r'/(?:src|share)/([\w-]+)/((?:config|launch|maps?|meshes|params?|rviz|urdf|worlds?)/.+)', path)
    if matched is None:
        return {}
    package, place = matched[1], matched[2].rstrip('/')
    sources = install_folders(find_workspaces(os.path.dirname(file), {}))[1]
    index = Index((), sources, read_source=read_source, underlay=None)
    folder, contents = index.source_folder(package), index.contents(package)
    if folder is not None and contents is not None:
        if not os.path.exists(source := os.path.join(folder, place)):
            return {}
        share = f'share/{package}/'
        built = [
            name
            for name, one in contents.files.items()
            if name.startswith(share) and os.path.realpath(one) == os.path.realpath(source)
        ]
        if not built and not os.path.isdir(source):
            return {'package': package, 'unbuilt': place}
        place = built[0].removeprefix(share) if built else place
    return {'package': package, 'parts': ', '.join(map(repr, place.split('/')))}
