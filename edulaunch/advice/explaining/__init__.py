"""`explain`: a launch file shown as a tree, in a terminal and in a notebook, with the origin of every value."""

from __future__ import annotations

from edulaunch.advice.explaining.explained import Comparison, Explanation, Reason, explain

__all__ = ['Comparison', 'Explanation', 'Reason', 'explain']
