"""Names that the C layer checks have to be texts."""

from __future__ import annotations

from typing import Any

from rclpy._rclpy_pybind11 import RCLError, RMWError


def check_is_text(name: Any, kind: str) -> None:
    """Raise what rclpy raises for a name that is no text.

    :param kind: 'node_name', 'namespace', 'topic_name' or 'full_topic_name'.
    :raises TypeError: for another thing.
    :raises RMWError, RCLError: for None.
    """
    if isinstance(name, str):
        return
    if name is None and kind == 'topic_name':
        raise RCLError('failed to validate name: topic_name argument is null')
    if name is None:
        what = kind.replace('_', ' ').removeprefix('full topic ')
        raise RMWError(f'failed to validate {what}: error not set')
    raise TypeError(
        f'rclpy_get_validation_error_for_{kind}(): incompatible function arguments: '
        f'a name must be a str, not {type(name).__name__}'
    )
