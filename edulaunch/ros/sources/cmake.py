"""Determines what a CMakeLists.txt installs, without running CMake.

This module evaluates these commands: project, set, list(APPEND), file(GLOB), get_filename_component, foreach,
install(PROGRAMS | FILES | DIRECTORY | TARGETS),
rosidl_generate_interfaces, ament_python_install_package, ament_auto_package(INSTALL_TO_SHARE ...). It evaluates all branches of
`if` except those of BUILD_TESTING.
"""

from __future__ import annotations

import os
from collections.abc import Iterator

from edulaunch.engine.packages.reading import Contents, Manifest, PackageWarning
from edulaunch.ros.sources.cmake_text import Command, commands, expand

_INTERFACES = ('.msg', '.srv', '.action')
_MADE = '/made-by-the-build'
"""Represents the build folder. The build creates the files that are installed from there, so the sources do not contain them."""
_MARKERS = 'share/ament_index/resource_index/packages'
_WORDS = frozenset(
    (
        'TARGETS',
        'FILES',
        'PROGRAMS',
        'DIRECTORY',
        'DESTINATION',
        'TYPE',
        'PATTERN',
        'REGEX',
        'EXCLUDE',
        'FILES_MATCHING',
        'RENAME',
        'OPTIONAL',
        'USE_SOURCE_PERMISSIONS',
        'PERMISSIONS',
        'FILE_PERMISSIONS',
        'DIRECTORY_PERMISSIONS',
        'COMPONENT',
        'CONFIGURATIONS',
        'RUNTIME',
        'LIBRARY',
        'ARCHIVE',
        'EXPORT',
        'INCLUDES',
        'MESSAGE_NEVER',
    )
)


def read_cmake_lists(manifest: Manifest) -> Contents:
    """Return the contents of an ament_cmake package. A command that cannot be evaluated causes a warning."""
    return _CMakeLists(manifest).read()


class _CMakeLists:
    """One CMakeLists.txt that is being read."""

    def __init__(self, manifest: Manifest) -> None:
        self.package = manifest.name
        self.folder = manifest.folder
        self.file = self.top = os.path.join(manifest.folder, 'CMakeLists.txt')
        self.contents = Contents()
        self.conditions = 0
        self.built: dict[str, int] = {}
        self.output_names: dict[str, str] = {}
        self.functions: dict[str, tuple[tuple[str, ...], list[Command]]] = {}
        self.variables: dict[str, list[str]] = {
            'PROJECT_NAME': [manifest.name],
            'CMAKE_PROJECT_NAME': [manifest.name],
            'CMAKE_INSTALL_PREFIX': [''],
            **dict.fromkeys(('CMAKE_CURRENT_BINARY_DIR', 'CMAKE_BINARY_DIR', 'PROJECT_BINARY_DIR'), [_MADE]),
            'PYTHON_INSTALL_DIR': ['lib/python3/site-packages'],
            'CMAKE_INSTALL_LIBDIR': ['lib'],
            'CMAKE_INSTALL_BINDIR': ['bin'],
            **dict.fromkeys(
                ('CMAKE_CURRENT_SOURCE_DIR', 'CMAKE_SOURCE_DIR', 'PROJECT_SOURCE_DIR', 'CMAKE_CURRENT_LIST_DIR'),
                [manifest.folder],
            ),
        }

    def read(self) -> Contents:
        try:
            with open(self.file, encoding='utf-8-sig', errors='replace') as stream:
                text = stream.read()
        except OSError:
            self.warn(0, 'is missing, so this ament_cmake package cannot be built')
            text = ''
        self._follow(list(commands(text)))
        for needed in (f'share/{self.package}/package.xml', f'{_MARKERS}/{self.package}'):
            self.contents.files.setdefault(needed, os.path.join(self.folder, 'package.xml'))  # ament_package() installs both
        return self.contents

    def warn(self, line: int, sentence: str) -> None:
        if self.conditions:
            return  # a build may skip this branch of an if()
        self.contents.warnings.append(PackageWarning(self.file, line, sentence))

    def _follow(self, todo: list[Command]) -> None:
        position = 0
        while position < len(todo):
            command = todo[position]
            position += 1
            if command.name == 'if' and 'BUILD_TESTING' in command.words:
                end = _end(todo, position, 'if')
                self._follow_tests(todo[position:end])
                position = end
            elif command.name == 'foreach':
                end = _end(todo, position, 'foreach')
                self._repeat(command, todo[position : end - 1])
                position = end
            elif command.name in ('function', 'macro'):
                end = _end(todo, position, command.name)
                self.functions[command.words[0].lower()] = (command.words[1:], todo[position : end - 1])
                position = end
            elif command.name in self.functions:
                self._call(command)
            else:
                self._obey(command)

    def _follow_tests(self, todo: list[Command]) -> None:
        """Evaluate only commands that add programs for tests, because launch tests start these programs.

        A build of the package needs no other command of this block.
        """
        for command in todo:
            words = expand(command, self.variables, lambda name: None)
            if command.name in _TEST_PROGRAMS and words:
                self.built[words[0]] = command.line
            elif command.name == 'install' and words[:1] == ['TARGETS']:
                self._install(command.line, words)

    def _obey(self, command: Command) -> None:
        if command.name not in _COMMANDS:
            self.conditions += {'if': 1, 'endif': -1}.get(command.name, 0)
            if 'install' in command.name or 'subdirectory' in command.name:
                self.contents.unread = self.contents.unread or f'{command.name}()'
            return
        unknown: list[str] = []
        words = expand(command, self.variables, unknown.append)
        if unknown and command.name in ('set', 'list', 'file', 'get_filename_component'):
            self.variables.pop((words or [''])[0], None)  # a value computed from an unknown value is unknown
            return
        if unknown:
            self.contents.unread = self.contents.unread or f'${{{unknown[0]}}}'
            sentence = f'uses ${{{unknown[0]}}}, whose value is not known without running CMake'
            self.contents.warnings.append(PackageWarning(self.file, command.line, sentence, 'unknown'))
        getattr(self, f'_{command.name}')(command.line, words)

    def _call(self, command: Command) -> None:
        """Evaluate the body of a function or macro of the file with its arguments. A recursive call is skipped."""
        names, body = self.functions.pop(command.name)
        expanded = expand(command, self.variables, lambda name: None)
        values = {'ARGN': expanded[len(names) :], 'ARGV': expanded}
        before = dict(self.variables)
        self.variables.update(values, **{name: [value] for name, value in zip(names, expanded, strict=False)})
        self._follow(body)
        self.variables = before
        self.functions[command.name] = (names, body)

    def _repeat(self, command: Command, body: list[Command]) -> None:
        words = expand(command, self.variables, lambda name: None)
        for item in [word for word in words[1:] if word not in ('IN', 'LISTS', 'ITEMS')]:
            for value in self.variables.get(item, [item]) if 'LISTS' in words else [item]:
                self.variables[words[0]] = [value]
                self._follow(body)

    # commands; each receives its line and its expanded words

    def _project(self, line: int, words: list[str]) -> None:
        self.variables['PROJECT_NAME'] = words[:1]
        if self.file != self.top:
            return  # a folder below has its own project
        self.variables['CMAKE_PROJECT_NAME'] = words[:1]
        if words and words[0] != self.package:
            self.warn(
                line,
                f'project({words[0]}) differs from the <name>{self.package}</name> of package.xml, '
                'so ament cannot build the package',
            )

    def _set(self, line: int, words: list[str]) -> None:
        if words:
            self.variables[words[0]] = [word for word in words[1:] if word not in ('CACHE', 'PARENT_SCOPE', 'FORCE')]

    def _list(self, line: int, words: list[str]) -> None:
        if len(words) > 1 and words[0] == 'APPEND':
            self.variables[words[1]] = self.variables.get(words[1], []) + words[2:]

    def _get_filename_component(self, line: int, words: list[str]) -> None:
        if len(words) < 3:
            return
        path, name = words[1], os.path.basename(words[1])
        stem, dot, ending = name.partition('.')
        values = {
            **dict.fromkeys(('DIRECTORY', 'PATH'), os.path.dirname(path)),
            **dict.fromkeys(('ABSOLUTE', 'REALPATH'), os.path.normpath(os.path.join(self.folder, path))),
            'NAME': name,
            'NAME_WE': stem,
            'EXT': dot + ending,
        }
        self.variables[words[0]] = [values.get(words[2], path)]

    def _file(self, line: int, words: list[str]) -> None:
        if len(words) < 3 or words[0] not in ('GLOB', 'GLOB_RECURSE'):
            return
        from glob import glob

        patterns = [word for word in words[2:] if word not in ('CONFIGURE_DEPENDS', 'LIST_DIRECTORIES', 'true', 'false')]
        base = ''
        if patterns[0] == 'RELATIVE':
            base, patterns = patterns[1], patterns[2:]
        found: list[str] = []
        for pattern in patterns:
            folder, name = os.path.split(os.path.join(self.folder, pattern))
            found += sorted(
                glob(
                    os.path.join(folder, '**', name) if words[0] == 'GLOB_RECURSE' else os.path.join(folder, name), recursive=True
                )
            )
        self.variables[words[1]] = [os.path.relpath(path, os.path.join(self.folder, base)) if base else path for path in found]

    def _add_executable(self, line: int, words: list[str]) -> None:
        if words:
            self.built[words[0]] = line

    def _ament_auto_add_executable(self, line: int, words: list[str]) -> None:
        self._add_executable(line, words)
        self._native(words[:1])

    def _rclcpp_components_register_node(self, line: int, words: list[str]) -> None:
        if 'EXECUTABLE' in words[:-1]:
            self.contents.native[words[words.index('EXECUTABLE') + 1]] = line

    def _set_target_properties(self, line: int, words: list[str]) -> None:
        if 'OUTPUT_NAME' in words[:-1] and 'PROPERTIES' in words:
            name = words[words.index('OUTPUT_NAME') + 1]
            self.output_names.update(dict.fromkeys(words[: words.index('PROPERTIES')], name))
            for target in words[: words.index('PROPERTIES')]:
                if target in self.contents.native:
                    self.contents.native[name] = self.contents.native.pop(target)

    def _ament_auto_package(self, line: int, words: list[str]) -> None:
        if 'INSTALL_TO_SHARE' in words:
            self._directories(line, words[words.index('INSTALL_TO_SHARE') + 1 :], f'share/{self.package}', [])

    def _ament_python_install_package(self, line: int, words: list[str]) -> None:
        if not words:
            return
        place = words[words.index('PACKAGE_DIR') + 1] if 'PACKAGE_DIR' in words[:-1] else words[0]
        path = os.path.normpath(os.path.join(self.folder, place))
        if os.path.isfile(os.path.join(path, '__init__.py')):
            self.contents.python_modules[words[0]] = path
        else:
            self.warn(line, f'ament_python_install_package({words[0]}) needs {place}/__init__.py, which is not there')

    def _rosidl_generate_interfaces(self, line: int, words: list[str]) -> None:
        for word in words[1:]:
            if word.endswith(_INTERFACES):
                self._file_at(line, word, f'share/{self.package}/{os.path.splitext(word)[1][1:]}')
        self.contents.interfaces |= any(word.endswith(_INTERFACES) for word in words)
        if words and words[0] != self.package and 'LIBRARY_NAME' not in words:
            self.warn(line, f'rosidl_generate_interfaces({words[0]} ...) must name the package, {self.package}')

    def _add_subdirectory(self, line: int, words: list[str]) -> None:
        """Evaluate the CMakeLists.txt of a subfolder with its own variables."""
        outer = self.folder, self.file, self.variables
        folder = os.path.normpath(os.path.join(self.folder, words[0])) if words else self.folder
        if not folder.startswith(self.folder + os.sep) or not os.path.isfile(os.path.join(folder, 'CMakeLists.txt')):
            return
        self.folder, self.file = folder, os.path.join(folder, 'CMakeLists.txt')
        self.variables = {**self.variables, **dict.fromkeys(('CMAKE_CURRENT_SOURCE_DIR', 'CMAKE_CURRENT_LIST_DIR'), [folder])}
        with open(self.file, encoding='utf-8-sig', errors='replace') as stream:
            self._follow(list(commands(stream.read())))
        self.folder, self.file, self.variables = outer

    def _install(self, line: int, words: list[str]) -> None:
        mode, items, destination, rest = _clauses([*words[:1], *(word for word in words[1:] if word != 'TARGETS')])
        if mode == 'TARGETS':
            self._native(items)
        elif not destination:
            if mode in ('FILES', 'PROGRAMS', 'DIRECTORY') and not {'TYPE', 'DESTINATION'} & {*rest}:
                self.warn(line, f'install({mode} ...) has no DESTINATION')
        elif mode == 'DIRECTORY':
            self._directories(line, items, destination, rest)
        elif mode in ('FILES', 'PROGRAMS'):
            for item in items:
                name = rest[rest.index('RENAME') + 1] if 'RENAME' in rest[:-1] else ''
                may_run = any(word.endswith('_EXECUTE') for word in rest)
                self._file_at(line, item, destination, name, program=may_run or mode == 'PROGRAMS')

    def _native(self, targets: list[str]) -> None:
        for name in targets:
            if name in self.built:
                self.contents.native[self.output_names.get(name, name)] = self.built[name]

    def _file_at(self, line: int, item: str, destination: str, name: str = '', program: bool = False) -> None:
        if item.startswith(_MADE):
            return
        path = os.path.normpath(os.path.join(self.folder, item))
        if not os.path.isfile(path):
            self.warn(line, f'{os.path.relpath(path, self.folder)} is not there, so the package does not build')
            return
        target = os.path.normpath(os.path.join(destination, name or os.path.basename(path)))
        self._add(target, path, program)

    def _add(self, target: str, path: str, program: bool) -> None:
        self.contents.files[target] = path
        if program or target.startswith('lib/') and os.access(path, os.X_OK):
            self.contents.programs.add(target)

    def _directories(self, line: int, items: list[str], destination: str, rest: list[str]) -> None:
        for item in items:
            top = os.path.normpath(os.path.join(self.folder, item))
            if item.startswith(_MADE):
                continue
            if not os.path.isdir(top):
                self.warn(line, f'installs the folder {os.path.relpath(top, self.folder)}/, which does not exist')
                continue
            base = destination if item.endswith('/') else os.path.join(destination, os.path.basename(top))
            for path in _files_below(top):
                if _matches(os.path.relpath(path, top), rest):
                    self._add(
                        os.path.normpath(os.path.join(base, os.path.relpath(path, top))),
                        path,
                        'USE_SOURCE_PERMISSIONS' in rest and os.access(path, os.X_OK),
                    )


_COMMANDS = frozenset(
    (
        'project',
        'set',
        'list',
        'file',
        'get_filename_component',
        'add_executable',
        'add_subdirectory',
        'ament_auto_add_executable',
        'ament_auto_package',
        'ament_python_install_package',
        'rclcpp_components_register_node',
        'rosidl_generate_interfaces',
        'install',
        'set_target_properties',
    )
)
KNOWN = _COMMANDS | {'ament_target_dependencies', 'rosidl_target_interfaces', 'set_target_properties', 'target_compile_features'}
KNOWN |= {'target_include_directories', 'target_link_libraries', 'add_dependencies', 'target_compile_definitions'}
"""Commands that install nothing which is not known."""
_TEST_PROGRAMS = frozenset(
    ('add_executable', 'ament_add_gtest', 'ament_add_gmock', 'ament_add_gtest_executable', 'ament_add_gmock_executable')
)


def _end(todo: list[Command], start: int, word: str) -> int:
    """Return the position after the `end<word>` that closes a block whose body begins at `start`."""
    depth = 1
    for position in range(start, len(todo)):
        depth += {word: 1, f'end{word}': -1}.get(todo[position].name, 0)
        if depth == 0:
            return position + 1
    return len(todo)


def _clauses(words: list[str]) -> tuple[str, list[str], str, list[str]]:
    """Return the mode, the items, the destination and all other words of an install()."""
    if not words:
        return '', [], '', []
    end = next((i for i, word in enumerate(words) if i and word in _WORDS), len(words))
    rest = words[end:]
    destination = rest[rest.index('DESTINATION') + 1] if 'DESTINATION' in rest[:-1] else ''
    return words[0], words[1:end], destination.lstrip('/'), rest


def _files_below(top: str) -> Iterator[str]:
    for folder, folders, files in os.walk(top):
        folders[:] = sorted(name for name in folders if name != '__pycache__')
        yield from (os.path.join(folder, name) for name in sorted(files))


def _matches(name: str, rest: list[str]) -> bool:
    """Return whether install(DIRECTORY) includes the file according to its FILES_MATCHING and PATTERN ... EXCLUDE clauses."""
    from fnmatch import fnmatchcase

    taken = 'FILES_MATCHING' not in rest
    for position, word in enumerate(rest):
        if word == 'PATTERN' and position + 1 < len(rest):
            hit = any(fnmatchcase(part, rest[position + 1]) for part in name.split(os.sep))
            excludes = rest[position + 2 : position + 3] == ['EXCLUDE']
            taken = taken and not hit if excludes else taken or hit
    return taken
