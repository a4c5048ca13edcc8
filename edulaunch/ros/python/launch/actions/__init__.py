"""Actions: what a launch file can ask for."""

from .._lazy import lazy_exports

_EXPORTS = {
    'configurations': (
        'PopLaunchConfigurations PushLaunchConfigurations ResetLaunchConfigurations SetLaunchConfiguration '
        'UnsetLaunchConfiguration'
    ),
    'declare_launch_argument': 'DeclareLaunchArgument',
    'environment': (
        'AppendEnvironmentVariable PopEnvironment PushEnvironment ResetEnvironment SetEnvironmentVariable '
        'UnsetEnvironmentVariable'
    ),
    'events': 'EmitEvent RegisterEventHandler Shutdown=shutdown_action UnregisterEventHandler',
    'execute_local': 'ExecuteLocal',
    'execute_process': 'ExecuteProcess',
    'group_action': 'GroupAction',
    'include_launch_description': 'IncludeLaunchDescription',
    'opaque': 'LogInfo OpaqueCoroutine OpaqueFunction',
    'timer_action': 'TimerAction',
}
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
