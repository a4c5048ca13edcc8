"""ROS 2 launch: describe a system of programs, then start and watch it.

The names, arguments, defaults, messages and rules are those of launch in ROS 2 Jazzy. Programs are started in
a simulation (`_engine.py` is the only place that knows it). Read `architecture.rst` of upstream's launch for
the ideas; each class here is at the relative path it has there.
"""

from ._lazy import lazy_exports

_EXPORTS = {
    'Action': 'action',
    'Condition': 'condition',
    'Event': 'event',
    'EventHandler': 'event_handler',
    'InvalidLaunchFileError': 'invalid_launch_file_error',
    'LaunchContext': 'launch_context',
    'LaunchDescription': 'launch_description',
    'LaunchDescriptionEntity': 'launch_description_entity',
    'LaunchDescriptionSource': 'launch_description_source',
    'LaunchIntrospector': 'launch_introspector',
    'LaunchService': 'launch_service',
    'SomeEntitiesType': 'some_entities_type',
    'SomeEntitiesType_types_tuple': 'some_entities_type',
    'SomeSubstitutionsType': 'some_substitutions_type',
    'SomeSubstitutionsType_types_tuple': 'some_substitutions_type',
    'Substitution': 'substitution',
    'actions': '',
    'conditions': '',
    'descriptions': '',
    'event_handlers': '',
    'events': '',
    'frontend': '',
    'launch_description_sources': '',
    'logging': '',
    'substitutions': '',
    'utilities': '',
}
_UPSTREAM_DOES_NOT_EXPORT = ('event_handlers', 'launch_description_sources', 'utilities')
_FILES = {
    'conditions': ('condition',),
    'events': ('event',),
    'substitution': ('some_substitutions_type',),
    'launch_description_entity': ('some_entities_type', 'some_actions_type'),
    'launch_description_source': ('invalid_launch_file_error',),
}
__all__ = [name for name in _EXPORTS if name not in _UPSTREAM_DOES_NOT_EXPORT]
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, _FILES)
