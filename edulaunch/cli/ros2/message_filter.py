"""The `--filter EXPR` of `ros2 topic echo` and `hz`: Python over one message `m`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


def message_filter(expression: str | None) -> Callable[[Any], bool]:
    """A test of messages; everything passes when there is no expression. It is the user's own code, as in ROS 2.

    :raises RuntimeError: when it is no expression; the test raises it when the expression fails for a message.
    """
    if expression is None:
        return lambda message: True
    try:
        code = compile(expression, '--filter', 'eval')
    except SyntaxError as error:
        raise RuntimeError(f'Invalid filter expression: {expression}\n  help: {error.msg}; as in: m.x > 1') from None

    def passes(message: Any) -> bool:
        try:
            return bool(eval(code, {'m': message}))
        except Exception as error:
            raise RuntimeError(f'Filter expression failed: {type(error).__name__}: {error}') from None

    return passes
