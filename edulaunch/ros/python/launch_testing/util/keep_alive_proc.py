"""A process that keeps a launch running."""

from __future__ import annotations

import os
from typing import Any

from launch.actions.execute_process import ExecuteProcess

from edulaunch.engine.underlay_place import underlay_prefix

KEEP_ALIVE_PROGRAM = os.path.join(underlay_prefix(), 'lib', 'launch_testing', 'keep_alive_proc')


class KeepAliveProc(ExecuteProcess):
    """A process that runs until SIGINT, so that the launch continues after all other processes have ended."""

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(cmd=[KEEP_ALIVE_PROGRAM], **kwargs)
