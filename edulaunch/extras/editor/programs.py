"""Find the file, the parameters and the topics of programs. Student programs are only read; built-in programs run for half a
second.
"""

from __future__ import annotations

import ast
import os
import re
from functools import lru_cache
from typing import NamedTuple

from edulaunch.advice.run_sources import name_of_call
from edulaunch.advice.texts import Around
from edulaunch.advice.texts.bound_names import text_of
from edulaunch.ros.sources.missing import source_package
from edulaunch.ros.sources.source_package import main_of, module_file, parsed, source_packages

MOMENT_S = 0.5
_FRAME = re.compile(r"""frame_id\s*=\s*['"]([\w/]+)['"]|frame-id['"]?,\s*['"]([\w/]+)['"]""")
MOST_FILES = 400
HIDDEN = ('qos_overrides.', 'start_type_description_service')
"""The parameters that ROS 2 itself declares for each node."""


class Interface(NamedTuple):
    """The interface of a program: its parameters with their defaults, and the types of its topics, by name."""

    parameters: dict[str, str]
    topics: dict[str, str]


def file_of(around: Around, package: str, executable: str) -> tuple[str, int] | None:
    """Return the file and line of a student's program, or None if they are unknown."""
    found = source_package(around.index, package)
    entry = None if found is None else found.contents.entry_points.get(f'lib/{package}/{executable}')
    if found is not None and entry is not None:
        path = module_file(found, entry[0])
        tree = None if path is None else parsed(path)
        if path is None:
            return None
        function = None if tree is None else main_of(tree, entry[1])
        return os.path.realpath(path), 1 if function is None else function.lineno
    script = None if found is None else found.contents.files.get(f'lib/{package}/{executable}')
    return None if script is None else (os.path.realpath(script), 1)


def interface_of(around: Around, package: str, executable: str) -> Interface:
    """Return the interface of a program. A student's program is read, but not run."""
    place = file_of(around, package, executable)
    if place is not None:
        return _read(place[0])
    if around.index.source_folder(package) is not None or executable not in around.executables(package):
        return Interface({}, {})
    return _of_built_in(package, executable)


def _read(path: str) -> Interface:
    tree = parsed(path)
    parameters: dict[str, str] = {}
    topics: dict[str, str] = {}
    for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)) if tree is not None else ():
        name = name_of_call(call)
        if name == 'declare_parameter' and call.args and (declared := text_of(call.args[0])):
            parameters[declared] = ast.unparse(call.args[1]) if len(call.args) > 1 else ''
        elif name in ('create_publisher', 'create_subscription') and len(call.args) > 1 and (topic := text_of(call.args[1])):
            topics[topic] = ast.unparse(call.args[0])
    return Interface(parameters, topics)


@lru_cache(maxsize=64)
def _of_built_in(package: str, executable: str) -> Interface:
    """Return the interface that a run of a built-in program shows. The program is not a student's code."""
    from edulaunch.engine.processes.spec import ProcessSpec
    from edulaunch.runtime.session import Session

    with Session(env={}) as session:
        session.host.start(ProcessSpec(argv=('ros2', 'run', package, executable), name=executable))
        session.run(MOMENT_S)
        recording = session.recording()
        parameters: dict[str, str] = {}
        topics: dict[str, str] = {}
        for node in recording.nodes:
            given = recording.parameters(node.name).items()
            parameters.update({name: str(one.value) for name, one in given if not name.startswith(HIDDEN)})
            for end in (*node.publishers, *node.subscriptions):
                topics[end[0].removeprefix('/')] = end[1]
    hidden = ('parameter_events', 'rosout')
    return Interface(parameters, {name: kind for name, kind in topics.items() if name not in hidden and '/_' not in name})


def frames(around: Around, text: str) -> list[str]:
    """Return the names of the frames in the file and in the Python files of the workspace."""
    found = set(_FRAME.findall(text))
    for path in [path for path in _files(around) if path.endswith('.py')][:MOST_FILES]:
        try:
            with open(path, encoding='utf-8') as file:
                found |= set(_FRAME.findall(file.read()))
        except (OSError, UnicodeDecodeError):
            continue
    return sorted({name for pair in found for name in pair if name})


def launch_files_around(around: Around) -> list[str]:
    """Return the launch files of the student's packages, and the launch files beside the file."""
    files = [path for path in _files(around) if path.endswith(('launch.py', 'launch.xml', 'launch.yaml', 'launch.yml'))]
    return sorted(set(files))[:MOST_FILES]


def _files(around: Around) -> list[str]:
    found = [os.path.realpath(path) for package in source_packages(around.index) for path in package.files()]
    beside = os.path.dirname(around.path)
    names = os.listdir(beside) if os.path.isdir(beside) else []
    return [*found, *(os.path.join(beside, name) for name in sorted(names))]
