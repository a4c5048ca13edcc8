"""The error for a launch file that no frontend can read."""

from __future__ import annotations

from ..invalid_launch_file_error import InvalidLaunchFileError


class InvalidFrontendLaunchFileError(InvalidLaunchFileError):
    """No parser can read the file. The message has one line for each parser that was tried."""
