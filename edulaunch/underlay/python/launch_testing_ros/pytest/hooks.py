"""What pytest makes of files marked `rostest`: the same as of launch tests."""

from launch_testing.pytest.hooks import LaunchTestItem as LaunchROSTestItem
from launch_testing.pytest.hooks import LaunchTestModule as LaunchROSTestModule
from launch_testing.pytest.hooks import pytest_addoption

__all__ = ['LaunchROSTestItem', 'LaunchROSTestModule', 'pytest_addoption']
