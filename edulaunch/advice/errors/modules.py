"""Modules that are not here, or not as they were imported, and what needs a real machine: other processes, windows, sockets."""

from __future__ import annotations

from edulaunch.advice.errors.about import about

ABSENT_MODULE = about(
    'packages.absent-module',
    what='the module {module} ({belongs_to}) is not part of edulaunch',
    why='on a robot it may be installed; here this program ends, and the others go on',
    do='try this program on a machine that has it, or leave that part out here',
)
ABSENT_PACKAGE = about(
    'packages.absent-package',
    what='the package {package} ({belongs_to}) is not part of edulaunch',
    why='on a robot it may be installed; here this program ends, and the others go on',
    do='leave it out here, or start it under a condition',
)
UNKNOWN_MODULE = about(
    'programs.unknown-module',
    what='there is no module {module}',
    do=(
        'write {near}',
        'go to its workspace, if it is yours; a Python package from elsewhere has to be installed in this environment',
    ),
    edits=(('{module}', '{near}', 'near'),),
)
UNKNOWN_INTERFACES = about(
    'messages.unknown-package',
    what='there is no package {module} with interfaces',
    do=('write {near}', 'put the package with these interfaces into the workspace'),
    edits=(('{module}', '{near}', 'near'),),
)
MODULE_PART = about(
    'programs.module-part',
    what=(
        'there is no module {module}; the nearest name is {parent}.{near}',
        'there is no module {module}; {parent} has: {known}',
        'there is no module {module}; {parent} has no modules',
    ),
    do=('write {parent}.{near}', 'look at the folder of {parent}, and name the file without .py'),
    edits=(('{module}', '{parent}.{near}'),),
)
COMPILED = about(
    'programs.compiled-module',
    what='the module {module} is compiled code ({compiled}); only Python runs here',
    why='this program ends, and the others go on',
    do='try this program where ROS 2 is installed',
)
NATIVE = about(
    'programs.native',
    what='this program is built from C++ ({built_from}); only Python programs run here',
    why='this program ends, and the others go on',
    do='try it where ROS 2 is installed, or write the node in Python',
    level='info',
)
LIBRARY = about(
    'programs.library',
    what="this program needs the native library '{library}', which this machine does not have",
    do='install it with the package manager of this machine',
)
NO_MODULE = about(
    'packages.no-module',
    what='the package {package} is there, but installs no module of that name',
    do='name its interfaces in rosidl_generate_interfaces() of CMakeLists.txt, or its Python package in packages= of setup.py',
)
OTHER_INTERFACES = about(
    'messages.other-interfaces', what='{package} has no interfaces of this kind', do='import from one of: {interfaces}'
)
IMPORT_CIRCLE = about(
    'programs.import-circle',
    what='{module} is still being imported: two modules import each other',
    do='write the import inside the function that needs it',
)
IMPORT_NAME = about(
    'programs.import-name',
    what=('{module} has no {missing}; it has: {known}', '{module} has no {missing}'),
    do=('write {near}', 'look into {module} for the name that you mean'),
    edits=(('{missing}', '{near}', 'near'),),
)
HIDES_MODULE = about(
    'programs.hides-module', what="{own_file} is taken for Python's own module {module}", do='give that file another name'
)
ENTRY_MODULE = about(
    'packages.entry-module',
    what="the entry point '{entry}' of {package} (setup.py) names the module {missing}, which is not there",
    do=('write {near}', 'name one of its modules: {known}', 'put the file into the folder of that name, beside its __init__.py'),
)
ENTRY_FUNCTION = about(
    'packages.entry-function',
    what="the entry point '{entry}' of {package} (setup.py) names the function {missing}, which is not there",
    do=('write {near}', 'name one of its functions: {known}', 'define it: def {missing}(args=None)'),
)

MULTIPROCESSING = about(
    'programs.multiprocessing',
    what='multiprocessing.{wanted} wants another process, and the simulation cannot copy a running program',
    do='use threading: Thread, queue.Queue, ThreadPoolExecutor; they work in simulated time',
)
WINDOW = about(
    'programs.window',
    what='this program opens a window, and the simulated machine has no screen',
    do='leave the window out here; turtlesim and rviz2 are drawn by edulaunch itself',
)
NOT_BUILT = about(
    'packages.not-built',
    what='{wanted} is a package of the workspace, and importlib.metadata knows only what `colcon build` writes',
    do='read its package.xml: get_package_share_directory({wanted!r}) has it',
)
ASYNCIO_PROGRAMS = about(
    'programs.asyncio-programs',
    what='asyncio cannot start programs here ({method})',
    do='start them with subprocess.run() or subprocess.Popen(), which wait in simulated time',
)
ASYNCIO_NETWORK = about(
    'programs.asyncio-network',
    what='the simulated machine has no network ({method})',
    do='let nodes talk over topics, services and actions',
)
ASYNCIO_KEYBOARD = about(
    'programs.asyncio-keyboard',
    what='asyncio cannot watch the keyboard here ({method})',
    do='read it with input() in a thread: await asyncio.to_thread(input)',
)
