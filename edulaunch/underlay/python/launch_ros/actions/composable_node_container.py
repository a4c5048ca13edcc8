"""A container for composable nodes, which loads what it contains; see `load_composable_nodes`."""

from .load_composable_nodes import ComposableNodeContainer

__all__ = ['ComposableNodeContainer']
