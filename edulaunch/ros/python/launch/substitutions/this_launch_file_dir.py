"""The substitution `ThisLaunchFileDir`."""

from __future__ import annotations

from .this_launch_file import ThisLaunchFile


class ThisLaunchFileDir(ThisLaunchFile):
    """The absolute path of the current launch file's folder.

    As in ROS 2, the current file is the file that was included last, even after launch has finished visiting it.

    :raises SubstitutionFailure: on evaluation, outside of launch files.
    """

    _local = 'current_launch_file_directory'
