"""Clients of actions, which send goals to action servers."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from action_msgs.msg import GoalStatus

from edulaunch.engine.sim.task import current_task
from edulaunch.ros.passed_on import passed_on
from edulaunch.ros.read_only import ReadOnly
from rclpy.client import Asker, parked_until_done
from rclpy.impl.entity import check_endpoint
from rclpy.impl.new_end_checks import checked_action_name
from rclpy.node_parts.core import core_of
from rclpy.process_state import process_state
from rclpy.qos import QoSProfile, engine_qos, qos_profile_action_status_default, qos_profile_services_default, validate_qos
from rclpy.task import Future, await_or_execute, future_answer
from rclpy.type_support import check_is_valid_action_type, wrong_class
from rclpy.waitable import NumberOfEntities, Waitable

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.impl.protocols import ExecutorProtocol
    from rclpy.node import Node

__all__ = ['ActionClient', 'ClientGoalHandle', 'GoalStatus']


class ClientGoalHandle:
    """One goal of a client. It is the result of the future that `send_goal_async` returns."""

    def __init__(self, action_client: ActionClient, goal_id: Any, goal_response: Any) -> None:
        self._action_client = action_client
        self._goal_id = goal_id
        self._goal_response = goal_response
        self._status = GoalStatus.STATUS_UNKNOWN

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClientGoalHandle) and bytes(self._goal_id.uuid) == bytes(other._goal_id.uuid)

    def __hash__(self) -> int:
        return hash(bytes(self._goal_id.uuid))

    def __repr__(self) -> str:
        return f'ClientGoalHandle <id={self._goal_id.uuid}, accepted={self.accepted}, status={self.status}>'

    goal_id: ReadOnly[Any] = ReadOnly("The goal's id, a unique_identifier_msgs/UUID.", '_goal_id')

    stamp: ReadOnly[Any] = ReadOnly('When the server accepted it.', '_goal_response.stamp')

    @property
    def accepted(self) -> bool:
        """Whether the server accepted the goal."""
        return bool(self._goal_response.accepted)

    @property
    def status(self) -> int:
        """The last known state of the goal, as a number of action_msgs/GoalStatus."""
        return int(self._status)

    def cancel_goal(self) -> Any:
        """Request the cancellation of the goal. Wait for the response, and return it. Another thread must spin."""
        return self._action_client._wait_for(self.cancel_goal_async())

    def cancel_goal_async(self) -> Future:
        """Request the cancellation of the goal. The result of the future is a CancelGoal.Response."""
        return self._action_client._cancel_goal_async(self)

    def get_result(self) -> Any:
        """Wait for the result of the goal, and return it. Another thread must spin."""
        return self._action_client._wait_for(self.get_result_async())

    def get_result_async(self) -> Future:
        """Request the result of the goal. The result of the future is a response with `.status` and `.result`."""
        return self._action_client._get_result_async(self)


class ActionClient(Asker, Waitable):
    """A client of an action."""

    def __init__(
        self,
        node: Node,
        action_type: Any,
        action_name: str,
        *,
        callback_group: CallbackGroup | None = None,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_sub_qos_profile: QoSProfile | int = 10,
        status_sub_qos_profile: QoSProfile = qos_profile_action_status_default,
    ) -> None:
        super().__init__(callback_group or node.default_callback_group)
        check_is_valid_action_type(action_type)
        self._name = checked_action_name(core_of(node), action_name, 'client')
        self._node = node
        self._action_type = action_type
        self._logger = node.get_logger().get_child('action_client')
        self._pending: dict[tuple[str, int], Future] = {}
        self._goal_ids: dict[int, Any] = {}
        self._asked_results: dict[int, bytes] = {}
        self._goal_handles: dict[bytes, ClientGoalHandle] = {}
        self._feedback_callbacks: dict[bytes, Callable[[Any], Any]] = {}
        node.add_waitable(self)
        self.callback_group.add_entity(self)
        impl = action_type.Impl
        self._goal_client = self._client('send_goal', impl.SendGoalService, goal_service_qos_profile)
        self._cancel_client = self._client('cancel_goal', impl.CancelGoalService, cancel_service_qos_profile)
        self._result_client = self._client('get_result', impl.GetResultService, result_service_qos_profile)
        self._feedback = self._subscribe('feedback', impl.FeedbackMessage, validate_qos(feedback_sub_qos_profile))
        self._status = self._subscribe('status', impl.GoalStatusMessage, status_sub_qos_profile)

    def get_num_entities(self) -> NumberOfEntities:
        """Return the number of entities of each kind that belong to this client."""
        return NumberOfEntities(num_subs=2, num_clients=3)

    def _client(self, part: str, srv_type: Any, qos: QoSProfile) -> Any:
        core = core_of(self._node)
        name = core.resolve(f'{self._name}/_action/{part}', 'service')
        return core.graph.create_client(core.entry, name, srv_type, engine_qos(qos), self.rcl_signal)

    def _subscribe(self, part: str, msg_type: Any, qos: QoSProfile) -> Any:
        core = core_of(self._node)
        name = core.resolve(f'{self._name}/_action/{part}', 'topic')
        return core.graph.create_subscription(core.entry, name, msg_type, engine_qos(qos), self.rcl_signal)

    def rcl_run_callback(self, executor: ExecutorProtocol) -> Any:
        """Process at most one response of each kind, one feedback message and one status message per turn, as rclpy does.

        As over a real network, the reply to a goal and its status arrive before the goal's first feedback. The last feedback
        of the goal arrives before the result.
        """
        self.queued = False
        sources = [('goal', self._goal_client), ('cancel', self._cancel_client), ('feedback', self._feedback)]
        if len(self._feedback.queue) <= 1:
            sources.append(('result', self._result_client))
        sources.append(('status', self._status))
        now = (sources[0], sources[-1]) if self._goal_client.queue else sources
        taken = [(kind, source.take()) for kind, source in now]
        if self._result_client.queue or any(source.queue for _, source in sources):
            self.rcl_signal()
        return self._handle_all(taken, executor)

    async def _handle_all(self, taken: list[tuple[str, Any]], executor: ExecutorProtocol) -> None:
        for kind, one in taken:
            if one is None:
                continue
            if kind == 'feedback':
                await self._handle_feedback(one[0])
            elif kind == 'status':
                self._handle_status(one[0])
            else:
                self._handle_answer(kind, one[0], one[1], executor)

    def _handle_answer(self, kind: str, sequence: int, wire: Any, executor: ExecutorProtocol) -> None:
        impl = self._action_type.Impl
        service = {'goal': impl.SendGoalService, 'cancel': impl.CancelGoalService, 'result': impl.GetResultService}[kind]
        answer = service.Response.from_wire(wire)
        if kind == 'goal':
            answer = ClientGoalHandle(self, self._goal_ids.pop(sequence), answer)
            if answer.accepted:
                self._goal_handles[bytes(answer.goal_id.uuid)] = answer
        elif kind == 'result':  # the goal has ended for its client, so it receives no more feedback
            self._feedback_callbacks.pop(self._asked_results.pop(sequence), None)
        future = self._pending.pop((kind, sequence), None)
        if future is not None:
            future._set_executor(executor)
            future.set_result(answer)

    async def _handle_feedback(self, wire: Any) -> None:
        message = self._action_type.Impl.FeedbackMessage.from_wire(wire)
        callback = self._feedback_callbacks.get(bytes(message.goal_id.uuid))
        if callback is not None:
            await await_or_execute(callback, message)

    def _handle_status(self, wire: Any) -> None:
        for entry in self._action_type.Impl.GoalStatusMessage.from_wire(wire).status_list:
            goal_uuid = bytes(entry.goal_info.goal_id.uuid)
            goal_handle = self._goal_handles.get(goal_uuid)
            if goal_handle is not None:
                goal_handle._status = entry.status
                if entry.status >= GoalStatus.STATUS_SUCCEEDED:
                    del self._goal_handles[goal_uuid]

    def send_goal(self, goal: Any, **kwargs: Any) -> Any:
        """Send a goal. Wait for the response with the result, and return it. Another thread must spin. Inside a callback, this
        call waits forever.
        """
        goal_handle = self._wait_for(self.send_goal_async(goal, **kwargs))
        return self._wait_for(self._get_result_async(goal_handle))

    def _wait_for(self, future: Future) -> Any:
        self.rcl_note_deadlock()
        parked_until_done(future)
        return future.result()

    def send_goal_async(self, goal: Any, feedback_callback: Callable[[Any], Any] | None = None, goal_uuid: Any = None) -> Future:
        """Send a goal. The result of the future is a :class:`ClientGoalHandle`, which exists when the server has replied.

        :param feedback_callback: called with each feedback message of the goal (`.goal_id`, `.feedback`).
        :param goal_uuid: the goal's ID, a unique_identifier_msgs/UUID; None means a random ID.
        :raises TypeError: unless `goal` is an `ActionType.Goal`.
        """
        if not isinstance(goal, self._action_type.Goal):
            raise wrong_class(goal, self._action_type, 'Goal')
        request_class = self._action_type.Impl.SendGoalService.Request
        request = request_class(goal_id=_random_uuid() if goal_uuid is None else goal_uuid, goal=goal)
        if feedback_callback is not None:
            self._feedback_callbacks[bytes(request.goal_id.uuid)] = feedback_callback
        if not self._goal_client.server_is_ready():
            from rclpy.impl.facts import note_lost_request

            note_lost_request(self._goal_client, self._name, 'action')
        sequence = self._goal_client.send(request_class.to_wire(request))
        self._goal_ids[sequence] = request.goal_id
        return self._remember('goal', sequence)

    def _cancel_goal_async(self, goal_handle: ClientGoalHandle) -> Future:
        self._check_handle(goal_handle)
        request = self._action_type.Impl.CancelGoalService.Request()
        request.goal_info.goal_id = goal_handle.goal_id
        return self._remember('cancel', self._cancel_client.send(type(request).to_wire(request)))

    def _get_result_async(self, goal_handle: ClientGoalHandle) -> Future:
        self._check_handle(goal_handle)
        request = self._action_type.Impl.GetResultService.Request(goal_id=goal_handle.goal_id)
        sequence = self._result_client.send(type(request).to_wire(request))
        self._asked_results[sequence] = bytes(goal_handle.goal_id.uuid)
        return self._remember('result', sequence)

    @staticmethod
    def _check_handle(goal_handle: ClientGoalHandle) -> None:
        if not isinstance(goal_handle, ClientGoalHandle):
            raise TypeError(f'Expected type ClientGoalHandle but received {type(goal_handle)}')

    def rcl_asked(self) -> tuple[Any, str, str]:
        """Return the endpoint that sends goals, the name of the action, and the word 'action'."""
        return self._goal_client, self._name, 'action'

    def _remember(self, kind: str, sequence: int) -> Future:
        future = future_answer(self)
        self._pending[kind, sequence] = future
        return future

    def server_is_ready(self) -> bool:
        """Return whether a server exists. Raise InvalidHandle after destroy, and RCLError after shutdown."""
        check_endpoint(self._goal_client, self._node.context, 'Failed to check if action server is available: rcl node')
        current_task().poll()
        return self._server_is_ready()

    def _server_is_ready(self) -> bool:
        return all(client.server_is_ready() for client in (self._goal_client, self._cancel_client, self._result_client))

    def wait_for_server(self, timeout_sec: float | None = None) -> bool:
        """Wait for a server, checking every 0.25 s as rclpy does. Return whether a server exists.

        :param timeout_sec: the longest wait in simulated seconds; None means no limit.
        """
        self.rcl_await_server(self._node.context, self._server_is_ready, timeout_sec)
        return self.server_is_ready()

    def destroy(self) -> None:
        """Remove the endpoints of this action client from the graph."""
        if self.destroyed:
            return
        self._node.remove_waitable(self)
        for endpoint in (self._goal_client, self._cancel_client, self._result_client, self._feedback, self._status):
            endpoint.destroy()


def _random_uuid() -> Any:
    """Return a random goal ID. The ID is the same in every run, and unique on this machine."""
    from unique_identifier_msgs.msg import UUID

    state = process_state()
    if state.goal_ids is None:
        state.goal_ids = state.process.sim.random(f'{state.process.name}/goal ids')
    taken = state.process.host.goal_ids
    while (found := state.goal_ids.getrandbits(128).to_bytes(16, 'big')) in taken:
        pass
    taken.add(found)
    return UUID(uuid=list(found))


__getattr__ = passed_on(__name__)
