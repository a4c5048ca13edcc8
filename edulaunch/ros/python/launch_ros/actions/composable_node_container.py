"""`ComposableNodeContainer` at its path in ROS 2."""

from .load_composable_nodes import ComposableNodeContainer as ComposableNodeContainer
