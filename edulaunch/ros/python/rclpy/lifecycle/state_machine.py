"""The lifecycle of a managed node: its states, its transitions, and its services."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.engine.facts import with_facts
from rclpy._rclpy_pybind11 import RCLError
from rclpy.impl.c_enum import Pybind11Enum
from rclpy.logging import get_logger
from rclpy.node_parts.core import core_of

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.impl.protocols import NodeProtocol
    from rclpy.lifecycle.managed_entity import ManagedEntity


class TransitionCallbackReturnType(Pybind11Enum):
    """The return values of a transition's callback. Programs import the class as `TransitionCallbackReturn`."""

    SUCCESS = 97
    FAILURE = 98
    ERROR = 99

    def to_label(self) -> str:
        """Return the label of the transition that this return value triggers, such as `transition_success`."""
        return f'transition_{self.name.lower()}'


TransitionCallbackReturn = TransitionCallbackReturnType


class LifecycleState(NamedTuple):
    """A state in the form that transition callbacks receive."""

    label: str
    state_id: int


class Transition(NamedTuple):
    """A transition: its trigger (`label`), its start state, its intermediate state, and the name of its callback."""

    number: int
    label: str
    start: str
    during: str
    callback: str


STATES = {
    label: LifecycleState(label, number)
    for label, number in (
        ('unknown', 0),
        ('unconfigured', 1),
        ('inactive', 2),
        ('active', 3),
        ('finalized', 4),
        ('configuring', 10),
        ('cleaningup', 11),
        ('shuttingdown', 12),
        ('activating', 13),
        ('deactivating', 14),
        ('errorprocessing', 15),
    )
}

TRANSITIONS = (
    Transition(1, 'configure', 'unconfigured', 'configuring', 'on_configure'),
    Transition(2, 'cleanup', 'inactive', 'cleaningup', 'on_cleanup'),
    Transition(3, 'activate', 'inactive', 'activating', 'on_activate'),
    Transition(4, 'deactivate', 'active', 'deactivating', 'on_deactivate'),
    Transition(5, 'shutdown', 'unconfigured', 'shuttingdown', 'on_shutdown'),
    Transition(6, 'shutdown', 'inactive', 'shuttingdown', 'on_shutdown'),
    Transition(7, 'shutdown', 'active', 'shuttingdown', 'on_shutdown'),
)


class Outcome(NamedTuple):
    """The transition that ends an intermediate state: its number, its label, and the next state."""

    number: int
    label: str
    goal: str


def _outcomes(first: int, success: str, failure: str, error: str = 'errorprocessing') -> dict[TransitionCallbackReturn, Outcome]:
    results = TransitionCallbackReturn.__members__.values()
    goals = (success, failure, error)
    return {result: Outcome(first + place, result.to_label(), goals[place]) for place, result in enumerate(results)}


OUTCOMES = {
    'configuring': _outcomes(10, 'inactive', 'unconfigured'),
    'cleaningup': _outcomes(20, 'unconfigured', 'inactive'),
    'activating': _outcomes(30, 'active', 'inactive'),
    'deactivating': _outcomes(40, 'inactive', 'active'),
    'shuttingdown': _outcomes(50, 'finalized', 'finalized'),
    'errorprocessing': _outcomes(60, 'unconfigured', 'finalized', 'finalized'),
}


def transition_from(state: str, wanted: int | str) -> Transition | None:
    """Return the transition with the given number or label that starts in a state, or None if there is no such transition."""
    for transition in TRANSITIONS:
        if transition.start == state and wanted in (transition.number, transition.label):
            return transition
    return None


def all_transitions() -> list[tuple[int, str, str, str]]:
    """Return (number, label, start state, goal state) for all transitions. The transitions that end an intermediate state follow
    the transition to this state.
    """
    found = []
    for state, outcomes in OUTCOMES.items():
        found += [(one.number, one.label, one.start, one.during) for one in TRANSITIONS if one.during == state]
        found += [(outcome.number, outcome.label, state, outcome.goal) for outcome in outcomes.values()]
    return found


class Life:
    """The lifecycle state of a node. It is stored with the other state of the node, so that a student's attributes cannot collide
    with it.

    :ivar entities: the managed entities, which follow the node through its states.
    """

    def __init__(self, node: NodeProtocol) -> None:
        self.node = node
        self.state = STATES['unconfigured']
        self.entities: list[ManagedEntity] = []
        self.services: LifecycleServices | None = None

    def tell_entities(self, callback: str, state: LifecycleState) -> TransitionCallbackReturn:
        """Call a method of each managed entity until one call does not return SUCCESS. Return the result of the last call."""
        for entity in self.entities:
            result: TransitionCallbackReturn = getattr(entity, callback)(state)
            if result is not TransitionCallbackReturn.SUCCESS:
                return result
        return TransitionCallbackReturn.SUCCESS

    def trigger(self, wanted: int | str) -> TransitionCallbackReturn:
        """Make a transition: call its callback, and then make the transition that the callback's result requires.

        :param wanted: the label or number of the transition.
        :raises RCLError: when the current state does not allow the transition.
        :raises AttributeError: when the callback returns anything but a TransitionCallbackReturn. As in rclpy, the node then
            stays in the intermediate state.
        """
        start = self.state
        transition = transition_from(start.label, wanted)
        if transition is None:
            get_logger('rcl_lifecycle').warning(f'No transition matching {wanted} found for current state {start.label}')
            raise with_facts(
                RCLError('Failed to trigger lifecycle state machine transition: Transition is not registered.'),
                'programs.no-transition',
                transition=next((one.label for one in TRANSITIONS if one.number == wanted), str(wanted)),
                node=self.node.get_fully_qualified_name(),
                state=start.label,
                possible=[f'{one.number} ({one.label})' for one in TRANSITIONS if one.start == start.label],
            )
        self._enter(transition.during)
        result = self._call(transition.callback, start)
        self._leave(result)
        if self.state.label == 'errorprocessing':
            self._leave(self._call('on_error', start))
        return result

    def trigger_shutdown(self) -> TransitionCallbackReturn:
        """Make the shutdown transition of the current state. Raise RCLError if the state has no such transition."""
        for transition in TRANSITIONS:
            if transition.start == self.state.label and transition.label == 'shutdown':
                return self.trigger(transition.number)
        raise RCLError('Shutdown transtion not possible')  # [sic]: ROS 2's own message

    def _call(self, callback: str, start: LifecycleState) -> TransitionCallbackReturn:
        function = getattr(self.node, callback)
        try:
            result = function(start)
        except (
            Exception
        ) as error:  # record a fact, because ROS 2 treats the value as TransitionCallbackReturn.ERROR without a message
            self._note(callback, {'raised': f'{type(error).__name__}: {error}'})
            return TransitionCallbackReturn.ERROR
        if not isinstance(result, TransitionCallbackReturn):
            self._note(callback, {'returned': repr(result)})
            result.to_label()  # an AttributeError, as in rclpy
        verdict: TransitionCallbackReturn = result
        return verdict

    def _note(self, callback: str, how: dict[str, str]) -> None:
        core = core_of(self.node)
        core.process.fact(
            'transition failed', (core.entry.index, callback), {'node': core.full_name, 'callback': callback, **how}
        )

    def _leave(self, result: TransitionCallbackReturn) -> None:
        self._enter(OUTCOMES[self.state.label][result].goal)

    def _enter(self, goal: str) -> None:
        start, self.state = self.state, STATES[goal]
        if self.services is not None:
            self.services.publish_event(start, self.state)


class StateMachineView:
    """The data of ROS 2's state machine that programs read from `node._state_machine`. A state is a pair (number, label).

    :ivar current_state: the current state.
    :ivar available_states: all states.
    :ivar transition_graph: all transitions, each with its number, label, start state and goal state.
    :ivar available_transitions: the transitions from the current state.
    """

    def __init__(self, life: Life) -> None:
        self.current_state = _pair(life.state.label)
        self.available_states = [_pair(label) for label in STATES]
        self.transition_graph = [(number, label, *_pair(start), *_pair(goal)) for number, label, start, goal in all_transitions()]
        self.available_transitions = [one for one in self.transition_graph if one[2:4] == self.current_state]


def _pair(label: str) -> tuple[int, str]:
    return STATES[label].state_id, label


class LifecycleServices:
    """The five services and the topic of a managed node."""

    def __init__(self, node: NodeProtocol, life: Life, group: CallbackGroup | None = None) -> None:
        from lifecycle_msgs import srv
        from lifecycle_msgs.msg import TransitionEvent

        self._life = life
        self._events = node.create_publisher(TransitionEvent, '~/transition_event', 10)
        for kind, name, answer in (
            (srv.ChangeState, 'change_state', self._on_change_state),
            (srv.GetState, 'get_state', self._on_get_state),
            (srv.GetAvailableStates, 'get_available_states', self._on_get_available_states),
            (srv.GetAvailableTransitions, 'get_available_transitions', self._on_get_available_transitions),
            (srv.GetAvailableTransitions, 'get_transition_graph', self._on_get_transition_graph),
        ):
            node.create_service(kind, f'{node.get_fully_qualified_name()}/{name}', answer, callback_group=group)

    def publish_event(self, start: LifecycleState, goal: LifecycleState) -> None:
        """Publish a change of state. As in ROS 2, the event contains the two states, but neither the time nor the transition."""
        from lifecycle_msgs.msg import TransitionEvent

        self._events.publish(TransitionEvent(start_state=_state(start), goal_state=_state(goal)))

    def _on_change_state(self, request: Any, response: Any) -> Any:
        """Make a requested transition. Reject an invalid label, and raise an error for an invalid number, as rclpy does."""
        label = request.transition.label
        try:
            response.success = self._life.trigger(label or request.transition.id) is TransitionCallbackReturn.SUCCESS
        except RCLError:
            if not label:
                raise
            response.success = False
        return response

    def _on_get_state(self, request: Any, response: Any) -> Any:
        response.current_state = _state(self._life.state)
        return response

    def _on_get_available_states(self, request: Any, response: Any) -> Any:
        response.available_states = [_state(state) for state in STATES.values()]
        return response

    def _on_get_available_transitions(self, request: Any, response: Any) -> Any:
        here = self._life.state.label
        response.available_transitions = [_description(*one) for one in all_transitions() if one[2] == here]
        return response

    def _on_get_transition_graph(self, request: Any, response: Any) -> Any:
        response.available_transitions = [_description(*one) for one in all_transitions()]
        return response


def _state(state: LifecycleState) -> Any:
    from lifecycle_msgs.msg import State

    return State(id=state.state_id, label=state.label)


def _description(number: int, label: str, start: str, goal: str) -> Any:
    from lifecycle_msgs.msg import Transition, TransitionDescription

    return TransitionDescription(
        transition=Transition(id=number, label=label), start_state=_state(STATES[start]), goal_state=_state(STATES[goal])
    )
