"""Rules about missing modules, wrong imports, and features that need a real computer: processes, windows and sockets."""

from __future__ import annotations

import os
from collections.abc import Iterator

from edulaunch.advice.errors.about import about, report
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.engine.nearest import nearest_spelling
from edulaunch.ros.sources.source_package import read_text

ABSENT_MODULE = about(
    'packages.absent-module',
    what='the module {module} ({belongs_to}) is not part of edulaunch',
    why='on a robot, the module may be installed; here, this program ends and the others continue',
    do='run this program on a computer where the module is installed, or leave that part out here',
    level='info',
    hides=('launch.fails',),
)
ABSENT_PACKAGE = about(
    'packages.absent-package',
    what='the package {package} ({belongs_to}) is not part of edulaunch',
    why='on a robot, the package may be installed; here, this program ends and the others continue',
    do='leave it out here, or add a condition to it',
    level='info',
    hides=('launch.fails',),
)
NEWER = {'turtlesim_msgs': 'turtlesim'}
"""Packages of interfaces in newer versions of ROS 2, and the packages in which Jazzy has these interfaces."""


@rule(
    'programs.unknown-module',
    what=('{beside} is a module of a package, so its full name is {full}', 'the module {module} does not exist'),
    do=(
        'write the full name, as in: from {full} import ...',
        'write {near}',
        'if you wrote the module, change to its workspace; otherwise, install it in this environment',
    ),
    level='error',
    edits=(('{module}', '{near}', 'near'),),
)
def unknown_module(failure: Failure) -> Iterator[Finding]:
    """Report the import of a module that does not exist, or of a module in the importing file's own package."""
    if failure.facts.get('about') == 'programs.unknown-module':
        module, folder = str(failure.facts.get('module')), os.path.dirname(failure.file or '')
        is_beside = all(os.path.isfile(os.path.join(folder, name)) for name in (f'{module}.py', '__init__.py'))
        full = f'{os.path.basename(folder)}.{module}' if is_beside else None
        yield report(failure, beside=f'{module}.py' if is_beside else None, full=full)


@rule(
    'messages.unknown-package',
    what=(
        'only versions of ROS 2 after Jazzy have the package {newer}; in Jazzy its interfaces are in {home}',
        'the interface package {module} does not exist',
    ),
    do=('write {home} in place of {newer}', 'write {near}'),
    level='error',
    edits=(('{newer}', '{home}', 'near'), ('{module}', '{near}', 'near')),
)
def unknown_package(failure: Failure) -> Iterator[Finding]:
    """Report an import from a message package that does not exist, such as `turtlesim_msgs`."""
    module = str(failure.facts.get('module'))
    if failure.facts.get('about') == 'messages.unknown-package' and (module in NEWER or failure.facts.get('near')):
        yield report(failure, newer=module if module in NEWER else None, home=NEWER.get(module))


@rule(
    'messages.other-package',
    what='the interface package {module} is not in this workspace, and it is not part of edulaunch',
    do='add the package with these interfaces to the workspace, or run this program where that package is installed',
    level='info',
)
def other_package(failure: Failure) -> Iterator[Finding]:
    """Report an import from a message package that is not available and whose name resembles no available package."""
    module, near = str(failure.facts.get('module')), failure.facts.get('near')
    if failure.facts.get('about') == 'messages.unknown-package' and module not in NEWER and not near:
        yield report(failure)


@rule(
    'programs.module-part',
    what=(
        'a build makes the module {generated}, but edulaunch does not run setup.py',
        'Python imports your file {own_file} in place of the package {parent}, because it is in the folder of the program',
        '{leaf} is a class in {parent}, not a module',
        'the module {module} does not exist; the nearest name is {parent}.{near}',
        'the module {module} does not exist; {parent} contains {known}',
        'the module {module} does not exist, because {parent} contains no modules',
    ),
    do=(
        'run this program where its package is built: {generated} comes from generate_parameter_library',
        'rename {own_file}, because no program may have the name of a package that it imports',
        'write: from {parent} import {leaf}',
        'write {parent}.{near}',
        'look into the folder of {parent}, and write the name of the file without .py',
    ),
    level='error',
    edits=(('{module}', '{parent}.{near}'),),
)
def module_part(failure: Failure) -> Iterator[Finding]:
    """Report a module that an existing package does not contain, or that only a build of the package generates."""
    if failure.facts.get('about') == 'programs.module-part':
        module = str(failure.facts.get('module'))
        setup = os.path.join(os.path.dirname(os.path.dirname(failure.file or '')), 'setup.py')
        text = read_text(setup) if os.path.isfile(setup) else ''
        is_made = 'generate_parameter_module(' in text and module.rpartition('.')[2] in text
        own = f'{str(failure.facts.get("parent")).partition(".")[0]}.py'
        is_hidden = os.path.isfile(os.path.join(os.path.dirname(failure.file or ''), own))
        home, _, leaf = module.rpartition('.')
        is_class = home.endswith(('.msg', '.srv', '.action')) and leaf[:1].isupper()
        yield report(
            failure, generated=module if is_made else None, own_file=own if is_hidden else None, leaf=leaf if is_class else None
        )


COMPILED = about(
    'programs.compiled-module',
    what='the module {module} is compiled code ({compiled}), but edulaunch runs only Python',
    why='this program ends, and the other programs continue',
    do='run this program where ROS 2 is installed',
    level='info',
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
    what="this program needs the native library '{library}', which is not installed on this computer",
    do='install it with the package manager of this computer',
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
    what=('the module {module} does not contain {missing}; it contains {known}', '{module} does not contain {missing}'),
    do=('write {near}', 'look up the name that you mean in {module}'),
    edits=(('{missing}', '{near}', 'near'),),
)
HIDES_MODULE = about(
    'programs.hides-module', what='Python imports {own_file} instead of its own module {module}', do='rename {own_file}'
)


@rule(
    'packages.entry-module',
    what=(
        'the folder {no_init} of {package} has no file __init__.py, so find_packages() does not find the module {missing}',
        "packages= in setup.py of {package} does not name '{unlisted}', so no build installs the module {missing}",
        "the entry point '{entry}' of {package} (setup.py) names the module {missing}, which does not exist",
    ),
    do=(
        'create the empty file {no_init}/__init__.py',
        "write packages=['{unlisted}'] in setup.py",
        'rename the file {bare} to {bare}.py',
        'write {near}',
        'use one of its modules: {known}',
        'put the file into the folder of that name, next to its __init__.py',
    ),
    level='error',
)
def entry_module(failure: Failure) -> Iterator[Finding]:
    """Report an entry point whose module does not exist, or is in a folder that setup.py does not install."""
    if failure.facts.get('about') == 'packages.entry-module':
        *above, leaf = str(failure.facts.get('missing')).split('.')
        source = failure.facts.get('source')
        folder = os.path.join(str(source), *above)
        is_there = bool(source and above) and os.path.isfile(os.path.join(folder, f'{leaf}.py'))
        is_package = os.path.isfile(os.path.join(folder, '__init__.py'))
        bare = '/'.join((*above, leaf))
        near = failure.facts.get('near')
        is_near = near is not None and nearest_spelling(leaf, [near.rpartition('.')[2]]) is not None
        yield report(
            failure,
            unlisted='.'.join(above) if is_there else None,
            no_init='/'.join(above) if is_there and not is_package and _finds_packages(str(source)) else None,
            bare=bare if source and os.path.isfile(os.path.join(str(source), bare)) else None,
            near=near if is_near else None,
        )


def _finds_packages(folder: str) -> bool:
    """Return whether the setup.py in a folder calls find_packages(), which needs an __init__.py in each folder."""
    return 'find_packages(' in read_text(os.path.join(folder, 'setup.py'))


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
    do='start programs with subprocess.run() or subprocess.Popen(), which wait in simulated time',
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
