"""What needs a real machine: other processes, windows, sockets."""

from __future__ import annotations

from edulaunch.advice.errors.about import about

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
