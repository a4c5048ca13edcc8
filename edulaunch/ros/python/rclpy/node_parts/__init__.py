"""What a node is made of: its entities, its parameters, its view of the graph, its names."""

from __future__ import annotations
