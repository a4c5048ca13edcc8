"""Numbers on command lines."""

from __future__ import annotations

import argparse


def positive(text: str) -> float:
    """A number above zero. Raises ArgumentTypeError for others, with the text of ROS 2."""
    value = float(text)
    if value <= 0:
        raise argparse.ArgumentTypeError('Value must be positive')
    return value
