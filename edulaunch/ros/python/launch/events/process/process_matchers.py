"""Matchers of processes."""

from __future__ import annotations

from .process_targeted_event import ProcessMatcher


def matches_pid(pid: int) -> ProcessMatcher:
    """Return a matcher for the process with this process ID."""
    return lambda action: action.process_details is not None and action.process_details['pid'] == pid


def matches_name(name: str) -> ProcessMatcher:
    """Return a matcher for the process with this unique name, such as 'talker-1'."""
    return lambda action: action.process_details is not None and action.process_details['name'] == name


def matches_executable(executable: str) -> ProcessMatcher:
    """Return a matcher for processes whose first word of the command line ends with this string."""
    return lambda action: action.process_details is not None and action.process_details['cmd'][0].endswith(executable)
