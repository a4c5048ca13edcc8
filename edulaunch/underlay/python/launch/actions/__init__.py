"""Actions: what a launch file can ask for."""

from .._lazy import lazy_exports

_EXPORTS = {
    'AppendEnvironmentVariable': 'append_environment_variable',
    'DeclareLaunchArgument': 'declare_launch_argument',
    'EmitEvent': 'emit_event',
    'ExecuteLocal': 'execute_local',
    'ExecuteProcess': 'execute_process',
    'GroupAction': 'group_action',
    'IncludeLaunchDescription': 'include_launch_description',
    'LogInfo': 'log_info',
    'OpaqueCoroutine': 'opaque_coroutine',
    'OpaqueFunction': 'opaque_function',
    'PopEnvironment': 'pop_environment',
    'PopLaunchConfigurations': 'pop_launch_configurations',
    'PushEnvironment': 'push_environment',
    'PushLaunchConfigurations': 'push_launch_configurations',
    'RegisterEventHandler': 'register_event_handler',
    'ResetEnvironment': 'reset_environment',
    'ResetLaunchConfigurations': 'reset_launch_configurations',
    'SetEnvironmentVariable': 'set_environment_variable',
    'SetLaunchConfiguration': 'set_launch_configuration',
    'Shutdown': 'shutdown_action',
    'TimerAction': 'timer_action',
    'UnregisterEventHandler': 'unregister_event_handler',
    'UnsetEnvironmentVariable': 'unset_environment_variable',
    'UnsetLaunchConfiguration': 'unset_launch_configuration',
}
_FILES = {
    'environment': (
        'append_environment_variable',
        'pop_environment',
        'push_environment',
        'reset_environment',
        'set_environment_variable',
        'unset_environment_variable',
    ),
    'configurations': (
        'pop_launch_configurations',
        'push_launch_configurations',
        'reset_launch_configurations',
        'set_launch_configuration',
        'unset_launch_configuration',
    ),
    'events': ('emit_event', 'register_event_handler', 'shutdown_action', 'unregister_event_handler'),
    'opaque': ('log_info', 'opaque_coroutine', 'opaque_function'),
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, _FILES)
