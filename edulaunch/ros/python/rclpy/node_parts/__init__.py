"""The parts of a node: its entities, its parameters, its queries of the graph, and its names."""

from __future__ import annotations
