"""Hooks that other plugins may implement."""

from __future__ import annotations

from edulaunch.testing.hooks import pytest_launch_collect_makemodule

__all__ = ['pytest_launch_collect_makemodule']
