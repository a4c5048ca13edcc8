"""tf2's checks of the frame names that are passed to a lookup."""

from __future__ import annotations

from collections.abc import Container

from edulaunch.engine.tf.failure import INVALID_ARGUMENT, LOOKUP, TransformFailure

ARGUMENTS = ('target_frame', 'source_frame', 'fixed_frame')


def check_name(frames: Container[str], name: str, function: str) -> None:
    """Raise an error unless a frame exists.

    :raises TransformFailure: with tf2's message, in which `function` is the called function.
    :raises TypeError: if the name is not a string, such as None from a parameter without a value.
    """
    if name in frames:
        return
    rule = _broken_rule(name)
    if rule:
        raise TransformFailure(INVALID_ARGUMENT, f'Invalid argument "{name}" passed to {function} - {rule}')
    raise TransformFailure(LOOKUP, f'"{name}" passed to {function} does not exist. ')


def check_names(frames: Container[str], *names: str) -> None:
    """Call :func:`check_name` for each argument of lookupTransform: target, source and fixed frame."""
    for name, argument in zip(names, ARGUMENTS, strict=False):
        check_name(frames, name, f'lookupTransform argument {argument}')


def problem(frames: Container[str], *names: str) -> str:
    """Return canTransform's message about its arguments, or '' if all frames are known."""
    for name, argument in zip(names, ARGUMENTS, strict=False):
        if name not in frames:
            rule = _broken_rule(name) or 'frame does not exist'
            return f'Invalid frame ID "{name}" passed to canTransform argument {argument} - {rule}'
    return ''


def _broken_rule(name: str) -> str:
    if not isinstance(name, str):
        raise TypeError(f'a frame name must be str, not {type(name).__name__}')
    if not name:
        return 'in tf2 frame_ids cannot be empty'
    return "in tf2 frame_ids cannot start with a '/'" if name.startswith('/') else ''
