"""The substitution `ThisLaunchFileDir`."""

from __future__ import annotations

from .this_launch_file import ThisLaunchFile


class ThisLaunchFileDir(ThisLaunchFile):
    """The absolute path of the current launch file's folder.

    "Current" is the file included last, also after its include has returned, as in ROS 2.

    :raises SubstitutionFailure: on evaluation, outside of launch files.
    """

    _local = 'current_launch_file_directory'
