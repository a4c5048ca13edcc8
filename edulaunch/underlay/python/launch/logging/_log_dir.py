"""The folder of one launch's log files."""

from __future__ import annotations

import os

from .._engine import environment, running_process


def _get_logging_directory() -> str:
    """The folder below which each launch makes its own: $ROS_LOG_DIR, else $ROS_HOME/log, else ~/.ros/log."""
    env = environment()
    log_dir = env.get('ROS_LOG_DIR')
    if not log_dir:
        log_dir = os.path.join(env.get('ROS_HOME') or os.path.join('~', '.ros'), 'log')
    return os.path.expanduser(log_dir)


def _make_unique_log_dir(*, base_path: str) -> str:
    """Make `base_path/YYYY-MM-DD-HH-MM-SS-microseconds-HOST-PID`, of the simulated time; `-2`, `-3` ... when
    that exists.
    """
    from socket import gethostname
    from time import gmtime, strftime

    process = running_process()
    seconds, ns = divmod(process.sim.now_ns, 1_000_000_000)
    date = strftime('%Y-%m-%d-%H-%M-%S', gmtime(seconds))
    name = f'{date}-{ns // 1000:06d}-{gethostname()}-{process.pid}'
    first = os.path.join(base_path, name)
    count = _free_number(first)
    while True:
        path = _numbered(first, count)
        try:
            os.makedirs(path)
            return path
        except FileExistsError:  # another program was faster
            count += 1


def _numbered(first: str, count: int) -> str:
    return first if count == 1 else f'{first}-{count}'


def _free_number(first: str) -> int:
    """A number that is not in use, found by halving: one launch after the other begins at the same simulated time."""
    if not os.path.exists(first):
        return 1
    taken, free = 1, 2
    while os.path.exists(_numbered(first, free)):
        taken, free = free, free * 2
    while free - taken > 1:
        middle = (taken + free) // 2
        if os.path.exists(_numbered(first, middle)):
            taken = middle
        else:
            free = middle
    return free


def _renew_latest_log_dir(*, log_dir: str) -> bool:
    """Let the link `latest` beside `log_dir` point to it. False when something else of that name is in the
    way.
    """
    link = os.path.join(os.path.dirname(log_dir), 'latest')
    if os.path.lexists(link):
        if not os.path.islink(link):
            return False
        os.unlink(link)
    os.symlink(os.path.basename(log_dir), link, target_is_directory=True)
    return True
