"""`pytest --nbval` compares the cells of a lesson with the outputs stored in .outputs."""

from edulaunch.course.stored import pytest_itemcollected

__all__ = ['pytest_itemcollected']
collect_ignore_glob = ['my_*']  # files of students have their own tests
