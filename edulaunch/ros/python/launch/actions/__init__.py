"""The actions that a launch file can request."""

from typing import TYPE_CHECKING

from .._late import late_names

if TYPE_CHECKING:
    from .append_environment_variable import AppendEnvironmentVariable as AppendEnvironmentVariable
    from .declare_launch_argument import DeclareLaunchArgument as DeclareLaunchArgument
    from .emit_event import EmitEvent as EmitEvent
    from .execute_local import ExecuteLocal as ExecuteLocal
    from .execute_process import ExecuteProcess as ExecuteProcess
    from .group_action import GroupAction as GroupAction
    from .include_launch_description import IncludeLaunchDescription as IncludeLaunchDescription
    from .log_info import LogInfo as LogInfo
    from .opaque_coroutine import OpaqueCoroutine as OpaqueCoroutine
    from .opaque_function import OpaqueFunction as OpaqueFunction
    from .pop_environment import PopEnvironment as PopEnvironment
    from .pop_launch_configurations import PopLaunchConfigurations as PopLaunchConfigurations
    from .push_environment import PushEnvironment as PushEnvironment
    from .push_launch_configurations import PushLaunchConfigurations as PushLaunchConfigurations
    from .register_event_handler import RegisterEventHandler as RegisterEventHandler
    from .reset_environment import ResetEnvironment as ResetEnvironment
    from .reset_launch_configurations import ResetLaunchConfigurations as ResetLaunchConfigurations
    from .set_environment_variable import SetEnvironmentVariable as SetEnvironmentVariable
    from .set_launch_configuration import SetLaunchConfiguration as SetLaunchConfiguration
    from .shutdown_action import Shutdown as Shutdown
    from .timer_action import TimerAction as TimerAction
    from .unregister_event_handler import UnregisterEventHandler as UnregisterEventHandler
    from .unset_environment_variable import UnsetEnvironmentVariable as UnsetEnvironmentVariable
    from .unset_launch_configuration import UnsetLaunchConfiguration as UnsetLaunchConfiguration
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {
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
        },
    )
