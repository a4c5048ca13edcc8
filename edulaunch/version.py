"""The version, for the command line and the build."""

__version__ = '0.1.0'
