"""Rules about missing launch files, launch files that return no launch description, and unknown names in Python launch files."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import about, in_share, report
from edulaunch.advice.launch_names import MODULES, home_of, import_line, names_in, nearest_anywhere
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.engine.nearest import nearest, nearest_spelling
from edulaunch.engine.packages.absent import absent_module_kind


@rule(
    'launch.no-generate',
    what='this launch file has no function generate_launch_description()',
    do=(
        'rename {near}() to generate_launch_description()',
        'write `def generate_launch_description(): return LaunchDescription([...])`',
    ),
    level='error',
    lesson='01_first_launch',
    edits=(('def {near}', 'def generate_launch_description'),),
)
def no_generate(failure: Failure) -> Iterator[Finding]:
    """Report a Python launch file without generate_launch_description()."""
    if 'does not contain the required function' in failure.message and failure.facts.get('about') != 'launch.test-description':
        yield report(failure)


IS_TEST = 'this file describes a launch test: it has generate_test_description() but no generate_launch_description()'
NOT_STARTED = '`ros2 launch` starts only launch files'
RUN_TEST = 'run it with: launch_test {file}'


@rule(
    'launch.test-description',
    what=IS_TEST,
    why=NOT_STARTED,
    do=RUN_TEST,
    level='info',
    hides=('launch.no-generate', 'launch.fails'),
)
def test_description(failure: Failure) -> Iterator[Finding]:
    """Report a launch test without generate_test_description()."""
    if failure.facts.get('about') == 'launch.test-description':
        yield report(failure)


@rule(
    'launch.other-source',
    what='{name} is a launch file in {language}, but PythonLaunchDescriptionSource reads only Python',
    do='use AnyLaunchDescriptionSource(...), which reads launch files in Python, XML and YAML',
    level='error',
    lesson='01_first_launch',
    hides=('launch.fails',),
)
def other_source(failure: Failure) -> Iterator[Finding]:
    """Report a file in another format that is included as a Python launch file."""
    name, ending = os.path.basename(failure.file or ''), os.path.splitext(failure.file or '')[1]
    if failure.type == 'SyntaxError' and failure.process is None and ending in ('.xml', '.yaml', '.yml'):
        yield report(failure, name=name, language='XML' if ending == '.xml' else 'YAML')


@rule(
    'launch.no-return',
    what='generate_launch_description() returned {returned}, not a LaunchDescription',
    do='end the function with: return LaunchDescription([...])',
    level='error',
    lesson='01_first_launch',
)
def no_return(failure: Failure) -> Iterator[Finding]:
    """Report a generate_launch_description() that returns nothing, or a list."""
    match = re.match(r"'(\w+)' object has no attribute 'get_launch_arguments", failure.message)
    if match is not None:
        yield report(failure, returned='nothing' if match[1] == 'NoneType' else f'a {match[1]}')


@rule(
    'launch.no-file',
    what=(
        '{upward} does not exist: the path goes up from the share folder of a package',
        'the folder {no_folder} does not exist',
        'the file {wanted} does not exist',
    ),
    do=(
        "write PathJoinSubstitution([FindPackageShare('{no_slash}'), ...]), because other ways to join strings add no / after "
        '{no_slash}',
        'find the file by its package with FindPackageShare: edulaunch does not build into the workspace, so {upward} differs',
        "write '{near}'",
        'write the path {below}, because the package has the file in that folder',
        "find the file with PathJoinSubstitution([FindPackageShare('{package}'), ...]), and check that "
        '{package} is built on this computer',
        'correct the path, or find the file by its package with FindPackageShare: {absolute} is not on this computer',
        'check the path: a launch file needs absolute paths, such as PathJoinSubstitution creates',
    ),
    level='error',
)
def no_file(failure: Failure) -> Iterator[Finding]:
    """Report a missing file that a launch file opens or includes."""
    if failure.type == 'FileNotFoundError' and failure.process is None and failure.facts.get('wanted'):
        built = re.search(r'/(?:install|share)/([\w-]+)/', failure.facts['wanted'] + '/')
        package = built[1] if built and failure.facts.get('no_folder') else None
        facts = {name: in_share(str(failure.facts[name])) for name in ('wanted', 'no_folder') if failure.facts.get(name)}
        absolute = next((path for path in facts.values() if os.path.isabs(path)), None)
        text = _text_of(failure.file)
        upward = absolute if absolute and _goes_up(text, absolute) else None
        absolute = None if absolute and not built and _is_relative(text, absolute) else absolute
        no_slash = _without_slash(str(failure.facts['wanted']))
        yield report(failure, package=package, absolute=absolute, upward=upward, no_slash=no_slash, **facts)


def _without_slash(path: str) -> str | None:
    """Return the package of a path such as ``share/turtlesimlaunch/...``, in which the slash after the package is missing."""
    match = re.match(r'(.*/share)/([^/]+)', path)
    if match is None or os.path.exists(match[0]) or not os.path.isdir(match[1]):
        return None
    return max((name for name in os.listdir(match[1]) if match[2].startswith(name)), key=len, default=None)


def _text_of(file: str | None) -> str:
    from edulaunch.ros.sources.source_package import read_text

    return read_text(file).replace('"', "'") if file else ''


def _goes_up(text: str, path: str) -> bool:
    """Return whether a launch file builds this path with '../..' from the share folder of a package."""
    return 'ackage' in text and path not in text and re.search(r"\.\./\.\.|'\.\.',\s*'\.\.'", text) is not None


def _is_relative(text: str, path: str) -> bool:
    """Return whether a launch file contains the end of a path as a string.

    Such a relative path depends on the current folder of the terminal.
    """
    ends = [f"'{path.split(os.sep, number)[-1]}'" for number in range(1, path.count(os.sep) + 1)]
    lines = (line for line in text.splitlines() if not re.search('ackage|__file__|[jJ]oin', line))
    return any(end in line for line in lines for end in ends)


ABSENT_FILE = about(
    'packages.absent-file',
    what='the package {package} ({belongs_to}) is not part of edulaunch, so its files do not exist here',
    do='remove this include here, or add a condition to it',
    level='info',
    hides=('launch.fails',),
)
NOT_SEARCHED = about(
    'packages.not-searched',
    what='the package {package} is in {below}, where edulaunch does not search from the current folder',
    do='change to that workspace with cd, or name it with --workspace {below}',
)
UNKNOWN_PACKAGE = about(
    'packages.unknown',
    what=('no package.xml below {searched} contains <name>{package}</name>', 'the package {package} does not exist'),
    do=(
        'write {near} if you mean that package',
        'check the <name> in the package.xml files below {searched}',
        'change to its workspace with cd, or name the workspace with --workspace DIR',
    ),
    edits=(('{package}', '{near}'),),
)
NO_MANIFEST = about(
    'packages.no-manifest',
    what='the folder {folder} has no package.xml, so it is not a package',
    do=('copy {template} to package.xml in that folder', 'add a package.xml to the folder; `ros2 pkg create` creates one'),
)
NOT_THIS_FOLDER = about(
    'packages.not-this-folder',
    what=(
        'colcon ignores the folder {folder} because it contains the file {ignored_by}',
        'colcon does not search the folder {folder}, because it is inside the package {inside}',
        'the <name> in the package.xml of {folder} differs from the name of the folder',
    ),
    do=('delete the file {ignored_by}', 'move the folder out of {inside}', 'write the name of the folder into <name>'),
)
BROKEN = about('packages.broken', what='this package cannot be built: {reason}', do='correct the line that the reason names')
ENTRY_GROUP = about(
    'packages.entry-group',
    what="entry_points in {written}:{at} has the key '{group}', so a build installs no programs of it",
    why='setuptools creates programs only from the key console_scripts, and ignores other keys',
    do="write '{near}'",
    lesson='07_packages',
)
INSTALLS_ELSEWHERE = about(
    'packages.installs-elsewhere',
    what="package.xml calls the package '{package}', but {written}:{at} installs its files into share/{other}",
    why='ROS 2 looks for the files of a package in the folder with the name in package.xml',
    do="write '{package}' in place of '{other}' in {written}",
    lesson='07_packages',
)
NOT_INSTALLED = about(
    'packages.not-installed',
    what='{source} exists, but the build does not install it',
    do=(
        'move it into the folder {beside}, where the installed files are',
        "move it into the folder {move}, and add (os.path.join('share', package_name, '{folder}'), glob('{pattern}')) "
        'to data_files of setup.py',
        "add (os.path.join('share', package_name, '{folder}'), glob('{pattern}')) to data_files of setup.py",
        'move it into the folder {move}, and add install(DIRECTORY {top} DESTINATION share/${{PROJECT_NAME}}) to CMakeLists.txt',
        'add install(DIRECTORY {top} DESTINATION share/${{PROJECT_NAME}}) to CMakeLists.txt',
    ),
    edits=(('', "(os.path.join('share', package_name, '{folder}'), glob('{pattern}'))", 'data_files'),),
)
BUILT_BEFORE = about(
    'packages.built-before',
    what='edulaunch reads {package} from {prefix}, which does not contain your changes since the last build',
    do='build the package again: colcon build --packages-select {package}',
)
MADE_BY_BUILD = about(
    'packages.made-by-build',
    what='a build creates {made} from {template}, but edulaunch does not run CMake',
    do='run this launch file where the package is built',
)
NO_SETUP_CFG = about(
    'packages.no-setup-cfg',
    what='setup.cfg does not install executables into lib/{package}, where ROS 2 looks for them',
    do='write this into setup.cfg: [install] with install_scripts=$base/lib/{package}',
)
NO_ENTRY_POINT = about(
    'packages.no-entry-point',
    what='{source} exists, but {build_file} does not install it as a program',
    do=(
        "add '{entry}' to console_scripts of setup.py",
        'add install(PROGRAMS {program} DESTINATION lib/${{PROJECT_NAME}}{rename}) to CMakeLists.txt',
    ),
    edits=(('', "'{entry}'", 'console_scripts'),),
)
NO_EXECUTABLE = about(
    'packages.no-executable',
    what="the package '{package}' has no executable named '{executable}'",
    do=(
        'start a launch file with: ros2 launch {package} {launch_file}',
        "write '{near}'",
        'write the package {owner}, which has an executable {executable}',
        'run the program where its package is built: {unread} in CMakeLists.txt may install it, but edulaunch cannot read that',
        'use one of its executables: {known}',
        'add it to entry_points in setup.py, or to install(PROGRAMS ...) in CMakeLists.txt',
    ),
    lesson='01_first_launch',
    edits=(('{executable}', '{near}'),),
)

_NOT_IN = re.compile(r"cannot import name '(?P<name>\w+)' from '(?P<module>[\w.]+)'")
_NO_ATTRIBUTE = re.compile(r"(?:partially initialized )?module '(?P<module>[\w.]+)' has no attribute '(?P<name>\w+)'")


@rule(
    'launch.import-name',
    what='{module} does not contain {missing}',
    do=('write: {line}', 'write {near_here}', 'look up the name that you mean in the documentation of {module}'),
    level='error',
    lesson='01_first_launch',
    edits=(('{missing}', '{near_here}'), ('from {module} import {missing}', '{line}', 'line')),
)
def import_name(failure: Failure) -> Iterator[Finding]:
    """Report an imported name that is misspelt, or that belongs to another module of launch."""
    match = _NOT_IN.match(failure.message) or _NO_ATTRIBUTE.match(failure.message)
    if match is None or failure.process is not None or match['module'].partition('.')[0] not in ('launch', 'launch_ros'):
        return
    name, module = match['name'], match['module']
    inner = [one.removeprefix(f'{module}.') for one in MODULES if one.startswith(f'{module}.')]
    here = [*names_in(module), *inner]
    near = name if home_of(name) else nearest(name, here) or nearest_anywhere(name)
    near_here = near if near is not None and near in here else None
    yield report(failure, module=module, missing=name, line=import_line(near), near_here=near_here)


@rule(
    'launch.relative-import',
    what='a launch file is not part of a package, so Python cannot resolve an import with a leading dot',
    do='put the shared code into your Python package, and write: from my_package.module import ...',
    level='error',
)
def relative_import(failure: Failure) -> Iterator[Finding]:
    """Report a relative import in a launch file, such as `from .other import x`."""
    if failure.process is None and failure.message.startswith('attempted relative import'):
        yield report(failure)


@rule(
    'launch.no-module',
    what=(
        'the module {absent} ({belongs_to}) is not part of edulaunch',
        '{file_beside} is next to the launch file, but Python does not search the folder of a launch file',
        'the module {wanted_module} does not exist',
    ),
    do=(
        "run this in the folder of edulaunch's setup.sh: pip install '.[{extra}]'",
        'write: from {near} import ...',
        'move {file_beside} into your Python package, and import it from there',
        'run this launch file on a computer where {absent} is installed',
        'change to the workspace that contains this module, or name it with --workspace DIR',
    ),
    level='error',
    edits=(('{wanted_module}', '{near}'),),
)
def no_module(failure: Failure) -> Iterator[Finding]:
    """Report an imported module that does not exist."""
    match = re.match(r"No module named '([\w.]+)'", failure.message)
    if match is None or failure.process is not None:
        return
    top = match[1].partition('.')[0]
    kind, beside = absent_module_kind(top), failure.facts.get('file_beside')
    near = None if kind or beside else misspelt(match[1])
    yield report(
        failure,
        wanted_module=match[1],
        module=top,
        absent=top if kind else None,
        belongs_to=kind,
        near=near,
        extra=EXTRAS.get(top),
    )


EXTRAS = {'xacro': 'urdf', 'urdf_parser_py': 'urdf', 'rosbags': 'bags'}
"""Modules that belong to an extra of edulaunch."""


def misspelt(module: str) -> str | None:
    """Return the module that this name misspells, in launch or ament_index_python. Return None if there is no such module.

    `launch_utils` is the name of a package, not a misspelling.
    """
    near = nearest_spelling(module, MODULES)
    top = module.partition('.')[0]
    tops = {one.partition('.')[0] for one in MODULES}
    return near if near is not None and (top in tops and near.startswith(top) or nearest_spelling(top, tops)) else None


@rule(
    'launch.unknown-name',
    what=(
        'the string {bare} has no quotes in a PythonExpression, so Python reads it as a name',
        'the name {missing} is not defined',
    ),
    do=(
        "put quotes around the substitution, as in [\"'\", LaunchConfiguration('x'), \"' == '{value}'\"]",
        'write {python}',
        'add this line: {line}',
        'write {near}, and add this line: {near_line}',
        'check that the name is spelled as in its definition',
    ),
    level='error',
    edits=(('{missing}', '{python}'), ('{missing}', '{near_bound}'), ('', '{line}', 'import')),
)
def unknown_name(failure: Failure) -> Iterator[Finding]:
    """Report an undefined name that has no import, is misspelt, or belongs to another language, such as `true`."""
    match = re.match(r"name '(\w+)' is not defined", failure.message)
    if match is None or failure.process is not None:
        return
    name = match[1]
    written = failure.facts.get('expression')
    bare = name if written else None
    value = 'true' if bare == 'false' and "'false'" not in str(written) else bare
    python = {'true': 'True', 'false': 'False', 'null': 'None', 'none': 'None'}.get(name)
    line = import_line(name)
    near = None if bare or python or line else nearest_anywhere(name)
    near_bound = None if bare or python or line else nearest_spelling(name, failure.facts.get('bound') or ())
    yield report(
        failure,
        missing=name,
        bare=bare,
        value=value,
        python=python,
        line=line,
        near=near,
        near_line=import_line(near),
        near_bound=near_bound,
    )


@rule(
    'launch.expression',
    what='Python cannot evaluate this PythonExpression: {expression}',
    do='check the quotes and spaces between the parts of the expression',
    level='error',
)
def expression(failure: Failure) -> Iterator[Finding]:
    """Report a PythonExpression that is not valid Python after its parts are joined."""
    if failure.facts.get('expression') and failure.type in ('SyntaxError', 'TypeError'):
        yield report(failure)
