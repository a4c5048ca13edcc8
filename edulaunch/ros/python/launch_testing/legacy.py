"""Tools of ROS 2 that are older than launch test files. Using such a tool raises an error that names the replacement."""

from typing import TYPE_CHECKING

from launch._late import late_names

from ._absent import ABSENT

if not TYPE_CHECKING:
    __all__, __getattr__, __dir__ = late_names(__name__, {}, absent=ABSENT['legacy'])
