"""ROS 2 launch: describe a system of programs, then start and watch it.

The names, arguments, defaults, messages and rules are those of launch in ROS 2 Jazzy. The programs are started in
a simulation. Only `_engine.py` uses the simulation. The file `architecture.rst` of upstream's launch explains
the ideas. Each class here has the same relative path as in upstream's launch.
"""

from typing import TYPE_CHECKING

from ._late import late_names

if TYPE_CHECKING:
    from . import actions as actions
    from . import conditions as conditions
    from . import descriptions as descriptions
    from . import event_handlers as event_handlers
    from . import events as events
    from . import frontend as frontend
    from . import launch_description_sources as launch_description_sources
    from . import logging as logging
    from . import some_actions_type as some_actions_type
    from . import substitutions as substitutions
    from . import utilities as utilities
    from .action import Action as Action
    from .condition import Condition as Condition
    from .event import Event as Event
    from .event_handler import EventHandler as EventHandler
    from .invalid_launch_file_error import InvalidLaunchFileError as InvalidLaunchFileError
    from .launch_context import LaunchContext as LaunchContext
    from .launch_description import LaunchDescription as LaunchDescription
    from .launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
    from .launch_description_source import LaunchDescriptionSource as LaunchDescriptionSource
    from .launch_introspector import LaunchIntrospector as LaunchIntrospector
    from .launch_service import LaunchService as LaunchService
    from .some_entities_type import SomeEntitiesType as SomeEntitiesType
    from .some_entities_type import SomeEntitiesType_types_tuple as SomeEntitiesType_types_tuple
    from .some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from .some_substitutions_type import SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple
    from .substitution import Substitution as Substitution
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {
            'Action': 'action',
            'Condition': 'condition',
            'EventHandler': 'event_handler',
            'Event': 'event',
            'LaunchContext': 'launch_context',
            'LaunchDescription': 'launch_description',
            'LaunchDescriptionEntity': 'launch_description_entity',
            'SomeEntitiesType': 'some_entities_type',
            'SomeEntitiesType_types_tuple': 'some_entities_type',
            'InvalidLaunchFileError': 'invalid_launch_file_error',
            'LaunchDescriptionSource': 'launch_description_source',
            'LaunchIntrospector': 'launch_introspector',
            'LaunchService': 'launch_service',
            'SomeSubstitutionsType': 'some_substitutions_type',
            'SomeSubstitutionsType_types_tuple': 'some_substitutions_type',
            'Substitution': 'substitution',
        },
        modules=('actions', 'conditions', 'descriptions', 'events', 'frontend', 'logging', 'substitutions'),
        attributes=('event_handlers', 'launch_description_sources', 'utilities', 'some_actions_type'),
    )
