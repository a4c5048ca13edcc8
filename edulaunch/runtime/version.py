"""The version of edulaunch, for the command line and the build."""

__version__ = '1.0.0'
