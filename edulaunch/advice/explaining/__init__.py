"""`explain` shows a launch file as a tree with the origin of every value, in a terminal or in a notebook."""

from __future__ import annotations

from edulaunch.advice.explaining.explained import Comparison, Explanation, Reason, explain

__all__ = ['Comparison', 'Explanation', 'Reason', 'explain']
