"""ROS 2 launch: describe a system of programs, then start and watch it.

The names, arguments, defaults, messages and rules are those of launch in ROS 2 Jazzy. Programs are started in
a simulation (`_engine.py` is the only place that knows it). Read `architecture.rst` of upstream's launch for
the ideas; each class here is at the relative path it has there.
"""

from ._lazy import lazy_exports

_EXPORTS = {
    '': (
        'actions conditions descriptions events frontend logging substitutions '
        '=event_handlers =launch_description_sources =utilities'
    ),
    'action': 'Action',
    'conditions': 'Condition',
    'event_handler': 'EventHandler',
    'events': 'Event',
    'launch_context': 'LaunchContext',
    'launch_description': 'LaunchDescription',
    'launch_description_entity': (
        'LaunchDescriptionEntity SomeEntitiesType SomeEntitiesType_types_tuple=some_entities_type =some_actions_type'
    ),
    'launch_description_source': 'InvalidLaunchFileError LaunchDescriptionSource',
    'launch_introspector': 'LaunchIntrospector',
    'launch_service': 'LaunchService',
    'substitution': 'SomeSubstitutionsType SomeSubstitutionsType_types_tuple=some_substitutions_type Substitution',
}
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
