"""A launch file in a frontend's format that cannot be read."""

from __future__ import annotations

from ..invalid_launch_file_error import InvalidLaunchFileError


class InvalidFrontendLaunchFileError(InvalidLaunchFileError):
    """No parser understands the text of the file; the message has one line per parser that was tried."""
