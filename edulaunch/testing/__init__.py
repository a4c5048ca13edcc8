"""Tests of a launch and plain tests of a package, as pytest and `launch_test` run them in simulated time.

`edulaunch/pytest_plugin.py` is the plugin that pytest finds; it loads what is here when a test file needs it.
"""
