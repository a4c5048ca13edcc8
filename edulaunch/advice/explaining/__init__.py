"""`explain` returns what a launch file does, as a tree with the origin of every value, for a terminal or a notebook."""

from __future__ import annotations

from edulaunch.advice.explaining.explained import Comparison, Explanation, Reason, explain

__all__ = ['Comparison', 'Explanation', 'Reason', 'explain']
