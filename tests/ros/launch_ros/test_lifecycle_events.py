"""Events of lifecycle nodes, and who they are for."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from launch import LaunchContext
from launch.actions import OpaqueFunction
from launch_ros.actions import LifecycleNode, LifecycleTransition, Node
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState, StateTransition
from launch_ros.events.lifecycle import matches_node_name as old_matcher
from launch_ros.events.matchers import matches_node_name


def transition(**labels: str) -> StateTransition:
    parts = {name: SimpleNamespace(label=labels.get(name, '')) for name in ('transition', 'start_state', 'goal_state')}
    message: Any = SimpleNamespace(timestamp=5, **parts)
    return StateTransition(action=SimpleNamespace(node_name='/m'), msg=message)  # type: ignore[arg-type]


def test_only_transitions_of_ros_can_be_asked_for() -> None:
    assert ChangeState(lifecycle_node_matcher=matches_node_name('m'), transition_id=1).transition_id == 1
    with pytest.raises(ValueError, match=r"transition_id '99' is not one of the valid transitions: TRANSITION_CONFIGURE \(1\)"):
        ChangeState(lifecycle_node_matcher=matches_node_name('m'), transition_id=99)


def test_a_node_is_matched_by_its_full_name() -> None:
    node = SimpleNamespace(node_name='/a/m')
    assert [matches_node_name(name)(node) for name in ('/a/m', 'a/m', 'm')] == [True, True, False]
    with pytest.warns(UserWarning, match='deprecated'):
        assert old_matcher('/a/m')(node)


def test_a_handler_looks_at_every_label_it_was_given() -> None:
    event = transition(start_state='inactive', goal_state='active')
    matching = [{}, {'goal_state': 'active'}, {'start_state': 'inactive', 'goal_state': 'active'}]
    other: list[dict[str, Any]] = [{'goal_state': 'inactive'}, {'transition': 'activate'}]
    assert [OnStateTransition(entities=[], **labels).matches(event) for labels in [*matching, *other]] == [True] * 3 + [False] * 2
    assert (event.timestamp, event.goal_state, event.name) == (5, 'active', 'launch_ros.events.lifecycle.StateTransition')


def test_a_matcher_of_ones_own_excludes_the_others() -> None:
    with pytest.raises(RuntimeError, match="'matcher' argument cannot be used together"):
        OnStateTransition(entities=[], matcher=lambda event: True, goal_state='active')


@pytest.mark.parametrize(
    ('names', 'transitions', 'text'),
    [([], [1], 'No lifecycle_node_names provided.'), (['/m'], [], 'No transition_ids provided.')],
)
def test_empty_lists_are_refused(names: list[Any], transitions: list[Any], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        LifecycleTransition(lifecycle_node_names=names, transition_ids=transitions)


def test_the_target_is_a_lifecycle_node() -> None:
    node = LifecycleNode(package='p', executable='e', name='n', namespace='')
    OnStateTransition(entities=[], target_lifecycle_node=node)
    other: Any = Node(package='p', executable='e')
    with pytest.raises(RuntimeError, match="^OnStateTransition requires a 'LifecycleNode' action as the target$"):
        OnStateTransition(entities=[], target_lifecycle_node=other)


def test_the_transitions_of_each_node_follow_each_other_and_end_with_an_error() -> None:
    context = LaunchContext()
    actions = LifecycleTransition(lifecycle_node_names=['/m', '/n'], transition_ids=['1', 3]).execute(context)
    assert [type(action).__name__ for action in actions] == ['RegisterEventHandler'] * 4 + ['EmitEvent'] * 2
    for action in actions[:4]:
        action.visit(context)
    assert len(context._event_handlers) == 6
    handled = [
        [
            type(entity).__name__
            for handler in list(context._event_handlers)
            if handler.matches(event)
            for entity in handle(handler, event, context)
        ]
        for event in (
            transition(start_state='unconfigured', goal_state='configuring'),
            transition(start_state='configuring', goal_state='inactive'),
            transition(start_state='deactivating', goal_state='inactive'),
            transition(start_state='activating', goal_state='errorprocessing'),
        )
    ]
    assert handled == [[], ['EmitEvent'], [], ['OpaqueFunction']]
    assert len(context._event_handlers) == 3, 'those of the other node'


def handle(handler: Any, event: Any, context: Any) -> Any:
    entities = handler.handle(event, context)
    for entity in entities:
        if isinstance(entity, OpaqueFunction):
            entity.visit(context)
    return entities


def test_one_transition_has_its_handler_too() -> None:
    actions = LifecycleTransition(lifecycle_node_names=['m'], transition_ids=['1']).execute(LaunchContext())
    assert [type(action).__name__ for action in actions] == ['RegisterEventHandler', 'EmitEvent']
    with pytest.raises(ValueError, match='^expected integer for lifecycle transition, got x$'):
        LifecycleTransition(lifecycle_node_names=['m'], transition_ids=['x']).execute(LaunchContext())
