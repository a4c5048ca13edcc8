"""Launch actions for ROS nodes: the interface of ROS 2's launch_ros.

ROS 2's launch_ros depends on `lifecycle_msgs`, `composition_interfaces` and other interface packages. These packages can be
imported wherever this package can be imported, even if a user has added the underlay to the path.
"""

from typing import TYPE_CHECKING

from launch._late import late_names

from edulaunch.engine.interfaces.importer import installed_registry

if TYPE_CHECKING:
    from . import actions as actions
    from . import descriptions as descriptions
    from . import event_handlers as event_handlers
    from . import events as events
    from . import parameter_descriptions as parameter_descriptions
    from . import parameters_type as parameters_type
    from . import remap_rule_type as remap_rule_type
    from . import ros_adapters as ros_adapters
    from . import substitutions as substitutions
    from . import utilities as utilities
    from .parameters_type import SomeParameters as SomeParameters
    from .remap_rule_type import SomeRemapRules as SomeRemapRules
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {'SomeParameters': 'parameters_type', 'SomeRemapRules': 'remap_rule_type'},
        modules=(
            'actions',
            'descriptions',
            'event_handlers',
            'events',
            'parameter_descriptions',
            'parameters_type',
            'remap_rule_type',
            'ros_adapters',
            'substitutions',
            'utilities',
        ),
    )

if installed_registry() is None:
    from edulaunch.engine.interfaces import install

    install()
