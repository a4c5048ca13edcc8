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
    path, count = os.path.join(base_path, name), 1
    while True:
        try:
            os.makedirs(path)
            return path
        except FileExistsError:
            count += 1
            path = os.path.join(base_path, f'{name}-{count}')


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
