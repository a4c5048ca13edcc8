"""Launch files that are not there, or do not give what a launch file gives."""

from __future__ import annotations

import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import about, speak
from edulaunch.advice.failure import Failure
from edulaunch.advice.finding import Finding
from edulaunch.advice.rule import rule


@rule(
    'launch.no-generate',
    what='this launch file has no function generate_launch_description()',
    do=(
        'rename {near}() to generate_launch_description()',
        'write: def generate_launch_description(): return LaunchDescription([...])',
    ),
    level='error',
    lesson='01_first_launch',
)
def no_generate(failure: Failure) -> Iterator[Finding]:
    """The function that every Python launch file has."""
    if 'does not contain the required function' in failure.message:
        yield speak(failure)


@rule(
    'launch.no-return',
    what='generate_launch_description() returned {returned}, not a launch description',
    do='end it with: return LaunchDescription([...])',
    level='error',
    lesson='01_first_launch',
)
def no_return(failure: Failure) -> Iterator[Finding]:
    """A forgotten `return`, or a list that was returned."""
    said = re.match(r"'(\w+)' object has no attribute 'get_launch_arguments", failure.message)
    if said is not None:
        yield speak(failure, returned='nothing' if said[1] == 'NoneType' else f'a {said[1]}')


@rule(
    'launch.no-file',
    what=('there is no folder {no_folder}', 'there is no file {wanted}'),
    do=("write '{near}'", 'look at the path: a launch file needs whole paths, such as PathJoinSubstitution makes'),
    level='error',
)
def no_file(failure: Failure) -> Iterator[Finding]:
    """A file that a launch file opens or includes."""
    if failure.type == 'FileNotFoundError' and failure.process is None and failure.facts.get('wanted'):
        yield speak(failure)


ABSENT_FILE = about(
    'packages.absent-file',
    what='the package {package} ({belongs_to}) is not part of edulaunch, so its files are not here',
    do='leave this part out here, or put it under a condition',
)
NOT_SEARCHED = about(
    'packages.not-searched',
    what='the package {package} lies in {below}, which is not searched from here',
    do='go there with cd, or name it with --workspace {below}',
)
UNKNOWN_PACKAGE = about(
    'packages.unknown',
    what=('no package.xml below {searched} has the <name> {package}', 'there is no package {package}'),
    do=(
        'write {near}, if that is the package you mean',
        'look at the <name> in the package.xml files below {searched}',
        'go to its workspace with cd, or name that with --workspace DIR',
    ),
)
NO_MANIFEST = about(
    'packages.no-manifest',
    what='there is a folder {folder}, but it has no package.xml, so it is no package',
    do='write a package.xml in it; `ros2 pkg create` makes one',
)
NOT_THIS_FOLDER = about(
    'packages.not-this-folder',
    what=(
        'the folder {folder} is left out because of the file {ignored_by} in it',
        'the package.xml in {folder} has another <name>',
    ),
    do=('take the file {ignored_by} out', 'write the name of the folder into <name>'),
)
BROKEN = about('packages.broken', what='this package cannot be built: {reason}', do='mend that line first')
NOT_INSTALLED = about(
    'packages.not-installed',
    what='{source} is there, but the build does not install it',
    do=(
        'move it into the folder {beside}, as the files that are installed',
        "move it into the folder {move}, and add (os.path.join('share', package_name, '{folder}'), glob('{pattern}')) "
        'to data_files of setup.py',
        "add (os.path.join('share', package_name, '{folder}'), glob('{pattern}')) to data_files of setup.py",
        'move it into the folder {move}, and add install(DIRECTORY {top} DESTINATION share/${{PROJECT_NAME}}) to CMakeLists.txt',
        'add install(DIRECTORY {top} DESTINATION share/${{PROJECT_NAME}}) to CMakeLists.txt',
    ),
)
BUILT_BEFORE = about(
    'packages.built-before',
    what='{package} is read from {prefix}, and what was written since its build is not in there',
    do='build it again: colcon build --packages-select {package}',
)
NO_SETUP_CFG = about(
    'packages.no-setup-cfg',
    what='setup.cfg does not put executables into lib/{package}, where ROS 2 looks for them',
    do='write into setup.cfg: [install] with install_scripts=$base/lib/{package}',
)
NO_ENTRY_POINT = about(
    'packages.no-entry-point',
    what='{source} is there, but {build_file} does not install it as a program',
    do=(
        "add '{entry}' to console_scripts of setup.py",
        'add install(PROGRAMS {program} DESTINATION lib/${{PROJECT_NAME}}) to CMakeLists.txt',
    ),
)
NO_EXECUTABLE = about(
    'packages.no-executable',
    what='{package} has no executable {executable}',
    do=(
        "write '{near}'",
        'choose one of these: {known}',
        'name it in entry_points of setup.py, or install(PROGRAMS ...) in CMakeLists.txt',
    ),
    lesson='01_first_launch',
)
