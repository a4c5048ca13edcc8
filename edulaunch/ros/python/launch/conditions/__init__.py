"""Conditions of actions."""

from typing import TYPE_CHECKING

from .._late import late_names

if TYPE_CHECKING:
    from .evaluate_condition_expression_impl import evaluate_condition_expression as evaluate_condition_expression
    from .if_condition import IfCondition as IfCondition
    from .invalid_condition_expression_error import InvalidConditionExpressionError as InvalidConditionExpressionError
    from .launch_configuration_equals import LaunchConfigurationEquals as LaunchConfigurationEquals
    from .launch_configuration_not_equals import LaunchConfigurationNotEquals as LaunchConfigurationNotEquals
    from .unless_condition import UnlessCondition as UnlessCondition
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {
            'IfCondition': 'if_condition',
            'InvalidConditionExpressionError': 'invalid_condition_expression_error',
            'LaunchConfigurationEquals': 'launch_configuration_equals',
            'LaunchConfigurationNotEquals': 'launch_configuration_not_equals',
            'UnlessCondition': 'unless_condition',
            'evaluate_condition_expression': 'evaluate_condition_expression_impl',
        },
    )
