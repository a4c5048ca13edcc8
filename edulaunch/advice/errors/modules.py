"""Rules about modules that are missing or were imported wrongly, and about features that need a real computer: processes,
windows, sockets.
"""

from __future__ import annotations

from collections.abc import Iterator

from edulaunch.advice.errors.about import about, report
from edulaunch.advice.rule import Failure, Finding, rule

ABSENT_MODULE = about(
    'packages.absent-module',
    what='the module {module} ({belongs_to}) is not part of edulaunch',
    why='on a robot the module may be installed; here this program ends, and the others continue',
    do='run this program on a machine where the module is installed, or leave that part out here',
)
ABSENT_PACKAGE = about(
    'packages.absent-package',
    what='the package {package} ({belongs_to}) is not part of edulaunch',
    why='on a robot the module may be installed; here this program ends, and the others continue',
    do='leave it out here, or give it a condition',
)
UNKNOWN_MODULE = about(
    'programs.unknown-module',
    what='the module {module} does not exist',
    do=('write {near}', 'if you wrote the module, change to its workspace; otherwise, install it in this environment'),
    edits=(('{module}', '{near}', 'near'),),
)
NEWER = {'turtlesim_msgs': 'turtlesim'}
"""Packages of interfaces in newer versions of ROS 2, and the packages in which Jazzy has these interfaces."""


@rule(
    'messages.unknown-package',
    what=(
        'only versions of ROS 2 after Jazzy have the package {newer}; in Jazzy its interfaces are in {home}',
        'the interface package {module} does not exist',
    ),
    do=('write {home} in place of {newer}', 'write {near}', 'add the package with these interfaces to the workspace'),
    level='error',
    edits=(('{newer}', '{home}', 'near'), ('{module}', '{near}', 'near')),
)
def unknown_package(failure: Failure) -> Iterator[Finding]:
    """Report an import from a package of messages that does not exist, such as `turtlesim_msgs`."""
    if failure.facts.get('about') == 'messages.unknown-package':
        module = str(failure.facts.get('module'))
        yield report(failure, newer=module if module in NEWER else None, home=NEWER.get(module))


MODULE_PART = about(
    'programs.module-part',
    what=(
        'the module {module} does not exist; the nearest name is {parent}.{near}',
        'the module {module} does not exist; {parent} contains {known}',
        'the module {module} does not exist, because {parent} contains no modules',
    ),
    do=('write {parent}.{near}', 'look into the folder of {parent}, and write the name of the file without .py'),
    edits=(('{module}', '{parent}.{near}'),),
)
COMPILED = about(
    'programs.compiled-module',
    what='the module {module} is compiled code ({compiled}), but edulaunch runs only Python',
    why='this program ends, and the other programs continue',
    do='run this program where ROS 2 is installed',
)
NATIVE = about(
    'programs.native',
    what='this program is built from C++ ({built_from}), but edulaunch runs only Python programs',
    why='this program ends, and the other programs continue',
    do='run it where ROS 2 is installed, or write the node in Python',
    level='info',
)
LIBRARY = about(
    'programs.library',
    what="this program needs the native library '{library}', which is not installed on this machine",
    do='install it with the package manager of this machine',
)
NO_MODULE = about(
    'packages.no-module',
    what='the package {package} exists, but it installs no module with that name',
    do='list its interfaces in rosidl_generate_interfaces() in CMakeLists.txt, or its Python package in packages= in setup.py',
)
OTHER_INTERFACES = about(
    'messages.other-interfaces', what='{package} has no interfaces of this kind', do='import from one of: {interfaces}'
)
IMPORT_CIRCLE = about(
    'programs.import-circle',
    what='{module} is not fully imported yet, because two modules import each other',
    do='write the import inside the function that needs it',
)
IMPORT_NAME = about(
    'programs.import-name',
    what=('{module} does not contain {missing}; it contains {known}', '{module} does not contain {missing}'),
    do=('write {near}', 'look up the name that you mean in {module}'),
    edits=(('{missing}', '{near}', 'near'),),
)
HIDES_MODULE = about(
    'programs.hides-module', what='Python imports {own_file} instead of its own module {module}', do='rename that file'
)
ENTRY_MODULE = about(
    'packages.entry-module',
    what="the entry point '{entry}' of {package} (setup.py) names the module {missing}, which does not exist",
    do=('write {near}', 'use one of its modules: {known}', 'put the file into the folder of that name, next to its __init__.py'),
)
ENTRY_FUNCTION = about(
    'packages.entry-function',
    what="the entry point '{entry}' of {package} (setup.py) names the function {missing}, which does not exist",
    do=('write {near}', 'use one of its functions: {known}', 'define the function: def {missing}(args=None)'),
)
ENTRY_NO_FUNCTION = about(
    'packages.entry-no-function',
    what="the entry point '{entry}' of {package} (setup.py) has no function after a colon",
    do=("write '{executable} = {near}'", "write the module, a colon and the function: '{executable} = package.module:function'"),
)

MULTIPROCESSING = about(
    'programs.multiprocessing',
    what='multiprocessing.{wanted} needs another process, but the simulation cannot copy a running program',
    do='use Thread, queue.Queue or ThreadPoolExecutor, which work in simulated time',
)
WINDOW = about(
    'programs.window',
    what='this program opens a window, but the simulated machine has no screen',
    do='leave the window out here; edulaunch itself draws turtlesim and rviz2',
)
NOT_BUILT = about(
    'packages.not-built',
    what='{wanted} is a package of the workspace, but importlib.metadata finds only packages built with `colcon build`',
    do='read its package.xml in get_package_share_directory({wanted!r})',
)
ASYNCIO_PROGRAMS = about(
    'programs.asyncio-programs',
    what='asyncio cannot start programs in the simulation ({method})',
    do='start them with subprocess.run() or subprocess.Popen(), which wait in simulated time',
)
ASYNCIO_NETWORK = about(
    'programs.asyncio-network',
    what='the simulated machine has no network ({method})',
    do='use topics, services and actions for communication between nodes',
)
ASYNCIO_KEYBOARD = about(
    'programs.asyncio-keyboard',
    what='asyncio cannot read the keyboard in the simulation ({method})',
    do='call input() in a thread: await asyncio.to_thread(input)',
)
