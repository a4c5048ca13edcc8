"""`pytest --nbval` compares the cells of a lesson with the outputs that are kept in .outputs."""

from edulaunch.course.stored import pytest_itemcollected

__all__ = ['pytest_itemcollected']
collect_ignore_glob = ['my_*']  # what a student writes has tests of its own
