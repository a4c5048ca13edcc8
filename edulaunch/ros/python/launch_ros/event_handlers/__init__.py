"""Handlers for events that know ROS."""

from .on_state_transition import OnStateTransition

__all__ = ['OnStateTransition']
