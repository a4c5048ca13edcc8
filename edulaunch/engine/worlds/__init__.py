"""Worlds: the turtles' canvas and a planar robot as plain numbers, without a node, a topic or a clock."""
