"""rclpy.lifecycle."""

from __future__ import annotations

from typing import Any

import pytest
import rclpy
from lifecycle_msgs.msg import Transition, TransitionEvent
from lifecycle_msgs.srv import ChangeState, GetAvailableTransitions, GetState
from rclpy._rclpy_pybind11 import RCLError
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.lifecycle import LifecycleNode, LifecycleNodeMixin, State, TransitionCallbackReturn
from rclpy.lifecycle.state_machine import all_transitions
from rclpy.node import Node
from std_msgs.msg import String

from edulaunch.engine.facts import facts_of

from .conftest import Ros, World


class Managed(LifecycleNode):
    """Says each transition; its publisher is managed."""

    def __init__(self, world: World, **options: Any) -> None:
        super().__init__('managed', **options)
        self.world = world
        self.verdict = TransitionCallbackReturn.SUCCESS

    def on_configure(self, state: State) -> TransitionCallbackReturn:
        self.world.say(('configure', state.label))
        self.chatter = self.create_lifecycle_publisher(String, 'chatter', 10)
        return self.verdict

    def on_activate(self, state: State) -> TransitionCallbackReturn:
        self.world.say(('activate', state.label))
        return super().on_activate(state)


def test_callbacks_are_told_of_the_state_before(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Managed(world)
        node.trigger_configure()
        node.trigger_activate()
        world.say(node._rclpy.life.state)

    assert ros(body) == [('configure', 'unconfigured'), ('activate', 'inactive'), State('active', 3)]


def test_managed_publishers_are_silent_while_inactive(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Managed(world)
        node.create_subscription(String, 'chatter', lambda message: world.say(message.data), 10)
        node.trigger_configure()
        node.chatter.publish(String(data='inactive'))
        node.trigger_activate()
        node.chatter.publish(String(data='active'))
        node.trigger_deactivate()
        node.chatter.publish(String(data='inactive'))
        rclpy.spin_once(node)
        rclpy.spin_once(node, timeout_sec=0.1)

    assert [what for what in ros(body) if isinstance(what, str)] == ['active']


@pytest.mark.parametrize(
    ('verdict', 'state'), [(TransitionCallbackReturn.FAILURE, 'unconfigured'), (TransitionCallbackReturn.ERROR, 'unconfigured')]
)
def test_failures_lead_back(ros: Ros, world: World, verdict: Any, state: str) -> None:
    def body() -> None:
        node = Managed(world)
        node.verdict = verdict
        world.say((node.trigger_configure(), node._rclpy.life.state.label))

    assert ros(body)[-1] == (verdict, state)


def test_an_exception_in_a_callback_is_an_error(ros: Ros, world: World) -> None:
    class Broken(LifecycleNode):
        def on_configure(self, state: State) -> TransitionCallbackReturn:
            raise ValueError('broken on purpose')

        def on_error(self, state: State) -> TransitionCallbackReturn:
            return TransitionCallbackReturn.FAILURE

    def body() -> None:
        node = Broken('n')
        world.say((node.trigger_configure(), node._rclpy.life.state.label))

    assert ros(body) == [(TransitionCallbackReturn.ERROR, 'finalized')]
    assert world.tracer.logs == []  # ROS 2 says nothing
    assert world.tracer.facts == [
        ('transition failed', {'node': '/n', 'callback': 'on_configure', 'raised': 'ValueError: broken on purpose'})
    ]


def test_a_callback_that_returns_nothing_leaves_the_node_between_two_states(ros: Ros, world: World) -> None:
    class Forgetful(LifecycleNode):
        def on_configure(self, state: State) -> TransitionCallbackReturn:  # type: ignore[return]
            pass

    def body() -> None:
        node = Forgetful('n')
        with pytest.raises(AttributeError, match="^'NoneType' object has no attribute 'to_label'$"):
            node.trigger_configure()
        with pytest.raises(RCLError):
            node.trigger_configure()
        world.say(node._rclpy.life.state.label)

    assert ros(body) == ['configuring']
    assert world.tracer.facts[0][1]['returned'] == 'None'


def test_transitions_that_do_not_start_here_are_refused(ros: Ros, world: World) -> None:
    def body() -> None:
        node = LifecycleNode('n')
        with pytest.raises(
            RCLError, match=r'^Failed to trigger lifecycle state machine transition: Transition is not registered\.$'
        ):
            node.trigger_activate()
        node.trigger_shutdown()
        with pytest.raises(RCLError, match='^Shutdown transtion not possible$'):
            node.trigger_shutdown()
        world.say('refused')

    assert ros(body) == ['refused']


def test_a_refused_transition_is_logged_by_rcls_state_machine(ros: Ros, world: World) -> None:
    def body() -> None:
        with pytest.raises(RCLError):
            LifecycleNode('n').trigger_activate()

    ros(body)
    assert world.tracer.logs == [(30, 'rcl_lifecycle', 'No transition matching 3 found for current state unconfigured')]


def test_a_node_of_ones_own_is_managed_by_the_mixin(ros: Ros, world: World) -> None:
    class Own(Node, LifecycleNodeMixin):
        def __init__(self) -> None:
            Node.__init__(self, 'own')
            self.group = ReentrantCallbackGroup()
            LifecycleNodeMixin.__init__(self, callback_group=self.group)

    def body() -> None:
        node = Own()
        node.trigger_configure()
        world.say(node._rclpy.life.state.label)
        world.say(sum(service.callback_group is node.group for service in node.services))

    assert ros(body) == ['inactive', 5]


def test_others_steer_a_managed_node_by_its_services(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')

        def ask(srv_type: Any, name: str, **fields: Any) -> Any:
            client = node.create_client(srv_type, f'managed/{name}')
            client.wait_for_service()
            future = client.call_async(srv_type.Request(**fields))
            rclpy.spin_until_future_complete(node, future)
            return future.result()

        for transition in (
            Transition(id=Transition.TRANSITION_CONFIGURE),
            Transition(id=Transition.TRANSITION_CLEANUP),
            Transition(label='shutdown'),
            Transition(label='activate'),
        ):
            world.say(
                (
                    ask(ChangeState, 'change_state', transition=transition).success,
                    ask(GetState, 'get_state').current_state.label,
                    [
                        one.transition.label
                        for one in ask(GetAvailableTransitions, 'get_available_transitions').available_transitions
                    ],
                )
            )

    def managed() -> None:
        rclpy.init()
        rclpy.spin(LifecycleNode('managed'))

    world.start(managed, name='managed')
    world.start(program)
    assert [what for _, _, what in world.run(2)] == [
        (True, 'inactive', ['cleanup', 'activate', 'shutdown']),
        (True, 'unconfigured', ['configure', 'shutdown']),
        (True, 'finalized', []),
        (False, 'finalized', []),
    ]


def test_a_number_that_does_not_suit_ends_the_managed_node(world: World) -> None:
    def program() -> None:
        rclpy.init()
        client = Node('n').create_client(ChangeState, 'managed/change_state')
        client.call_async(ChangeState.Request(transition=Transition(id=Transition.TRANSITION_ACTIVATE)))

    def managed() -> None:
        rclpy.init()
        with pytest.raises(RCLError, match='Transition is not registered') as refused:
            rclpy.spin(LifecycleNode('managed'))
        world.say(facts_of(refused.value)['possible'])

    world.start(managed, name='managed')
    world.start(program)
    assert world.run(1) == [(0.0, 'managed', ['1 (configure)', '5 (shutdown)'])]


def test_transitions_are_told_with_those_that_end_them() -> None:
    numbers = [number for number, *_ in all_transitions()]
    assert numbers == [1, 10, 11, 12, 2, 20, 21, 22, 3, 30, 31, 32, 4, 40, 41, 42, 5, 6, 7, 50, 51, 52, 60, 61, 62]


def test_events_tell_the_states_only(ros: Ros, world: World) -> None:
    def body() -> None:
        node = LifecycleNode('n')
        node.create_subscription(
            TransitionEvent,
            '~/transition_event',
            lambda event: world.say((event.timestamp, event.transition.id, event.start_state.label, event.goal_state.label)),
            10,
        )
        node.trigger_configure()
        for _ in range(2):
            rclpy.spin_once(node, timeout_sec=0.1)

    assert ros(body) == [(0, 0, 'unconfigured', 'configuring'), (0, 0, 'configuring', 'inactive')]


def test_only_managed_entities_follow_a_node(ros: Ros, world: World) -> None:
    def body() -> None:
        with pytest.raises(TypeError, match=r'^Expected a rclpy\.lifecycle\.ManagedEntity instance\.$'):
            LifecycleNode('n').add_managed_entity(5)  # type: ignore[arg-type]
        world.say(repr(TransitionCallbackReturn.SUCCESS))

    assert ros(body) == ['<TransitionCallbackReturnType.SUCCESS: 97>']


def test_the_services_can_be_left_out(ros: Ros, world: World) -> None:
    ros(
        lambda: world.say(
            [
                service.srv_name
                for service in LifecycleNode('n', enable_communication_interface=False).services
                if 'state' in service.srv_name
            ]
        )
    )
    assert [what for _, _, what in world.log] == [[]]


def test_results_of_callbacks_cannot_be_listed_or_searched_as_in_ros() -> None:
    kind: Any = TransitionCallbackReturn
    for use in (list, len, lambda each: each['SUCCESS'], lambda each: 'SUCCESS' in each):
        with pytest.raises(TypeError, match='pybind11'):
            use(kind)
    assert (int(kind.ERROR), kind(97), hash(kind.SUCCESS)) == (99, kind.SUCCESS, 97)
