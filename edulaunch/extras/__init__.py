"""Extras: plug-ins that can be deleted, folder by folder, while everything else goes on working.

`network/`, `native/` and `comparing/` join a real ROS 2 network, run launch files on the real rclpy, and compare both.
`editor/` helps where launch files are written.
`testing/` and `pytest_plugin/` run the tests of ROS packages on the simulated machine.
An extra may import every other wing, and no other wing imports an extra: it is found by its entry points.
Start reading with the entry points in `pyproject.toml`.
"""
