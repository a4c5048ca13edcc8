"""Extras: plug-ins that can be deleted, folder by folder, while everything else continues to work.

`network/`, `native/` and `comparing/` join a real ROS 2 network, run launch files on the real rclpy, and compare such runs with
simulations. `editor/` has a language server for launch files.
`testing/` and `pytest_plugin/` run the tests of ROS packages on the simulated machine.
An extra may import all other parts of edulaunch. No other part imports an extra; entry points find it.
Start reading with the entry points in `pyproject.toml`.
An import is inside a function only if most uses of the module do not need it.
"""
