"""Worlds: the turtles on their canvas, and a planar robot. They are plain numbers, without a node, a topic or a clock."""
