"""Conditions, which decide at launch time whether an action is executed."""

from .._lazy import lazy_exports

_EXPORTS = {
    'IfCondition': 'if_condition',
    'InvalidConditionExpressionError': 'invalid_condition_expression_error',
    'LaunchConfigurationEquals': 'launch_configuration_equals',
    'LaunchConfigurationNotEquals': 'launch_configuration_not_equals',
    'UnlessCondition': 'unless_condition',
    'evaluate_condition_expression': 'evaluate_condition_expression_impl',
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
