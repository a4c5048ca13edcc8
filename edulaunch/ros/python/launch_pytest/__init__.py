"""ROS 2 launch_pytest: tests of a running launch description in plain pytest.

A fixture describes what to launch (`@launch_pytest.fixture`), and tests name the fixture: `@pytest.mark.launch(fixture=...)`.
The names and rules are those of launch_pytest in ROS 2 Jazzy, but time is simulated.
"""

from typing import TYPE_CHECKING

from launch._late import late_names

from .fixture import fixture as fixture

if TYPE_CHECKING:
    from . import actions as actions
    from . import plugin as plugin
    from . import tools as tools
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__, {}, modules=('actions', 'tools'), attributes=('plugin',), eager=('fixture',)
    )
