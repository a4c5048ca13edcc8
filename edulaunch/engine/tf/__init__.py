"""Transforms and their time-ordered buffer: numbers only, no node, no topic, no message.

Read `quaternions.py` and `transforms.py` (the maths), `history.py` (one frame over time), `path.py` (the
usual lookup), `walk.py` (the lookup in all its detail) and `buffer.py` (what ties them together).
"""

from __future__ import annotations

from edulaunch.engine.tf.buffer import TransformBuffer
from edulaunch.engine.tf.failure import TransformFailure
from edulaunch.engine.tf.missing import explain_missing

__all__ = ['TransformBuffer', 'TransformFailure', 'explain_missing']
