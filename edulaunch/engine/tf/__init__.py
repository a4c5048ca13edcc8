"""Transforms and their time-ordered buffer, as numbers: without nodes, topics or messages.

Read `quaternions.py` and `transforms.py` (the maths), then `history.py` (one frame over time) and `path.py` (the usual lookup).
`walk.py` handles all other lookups, and `buffer.py` combines these files.
"""

from __future__ import annotations

from edulaunch.engine.tf.buffer import TransformBuffer
from edulaunch.engine.tf.failure import TransformFailure

__all__ = ['TransformBuffer', 'TransformFailure']
