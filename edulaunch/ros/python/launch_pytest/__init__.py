"""ROS 2 launch_pytest: tests of a running launch description in plain pytest.

A fixture describes what to launch (`@launch_pytest.fixture`), and tests name it: `@pytest.mark.launch(fixture=...)`. Names and
rules are those of launch_pytest in ROS 2 Jazzy; time is simulated.
"""

from launch._lazy import lazy_exports

from .fixture import fixture

__all__ = ['fixture']
__getattr__, __dir__ = lazy_exports(__name__, {'': 'actions tools =plugin'})
