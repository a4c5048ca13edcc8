"""`ComposableNodeContainer`, importable from the same path as in ROS 2."""

from .load_composable_nodes import ComposableNodeContainer as ComposableNodeContainer
