"""Servers of actions."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from typing import TYPE_CHECKING, Any

from action_msgs.msg import GoalStatus

from edulaunch.engine.facts import kind_of, with_facts
from edulaunch.engine.processes.current import current_process
from edulaunch.ros.passed_on import passed_on
from edulaunch.ros.read_only import ReadOnly
from rclpy._rclpy_pybind11 import RCLError
from rclpy.action.server_goal_handle import GoalEvent, GoalState, ServerGoalHandle, goal_info, has_ended_until, stamp_of
from rclpy.impl.new_end_checks import checked_action_name
from rclpy.impl.refusals import after_shutdown
from rclpy.node_parts.core import core_of
from rclpy.qos import QoSProfile, engine_qos, qos_profile_action_status_default, qos_profile_services_default, validate_qos
from rclpy.task import Future, await_or_execute
from rclpy.type_support import check_is_valid_action_type, wrong_class
from rclpy.waitable import NumberOfEntities, Waitable

if TYPE_CHECKING:
    from edulaunch.engine.graph.services import RequestId, ServiceServer
    from rclpy.callback_groups import CallbackGroup
    from rclpy.impl.protocols import ExecutorProtocol
    from rclpy.node import Node


class GoalResponse(Enum):
    """The return values of a goal callback."""

    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    """The return values of a cancel callback."""

    REJECT = 1
    ACCEPT = 2


def default_handle_accepted_callback(goal_handle: ServerGoalHandle) -> None:
    """Execute the goal."""
    goal_handle.execute()


def default_goal_callback(goal_request: Any) -> GoalResponse:
    """Accept every goal."""
    return GoalResponse.ACCEPT


def default_cancel_callback(cancel_request: Any) -> CancelResponse:
    """Reject every cancel request."""
    return CancelResponse.REJECT


class ActionServer(Waitable):
    """A server of one action.

    :param execute_callback: executes a goal. It receives the :class:`ServerGoalHandle`, calls `succeed()`, `abort()` or
        `canceled()` on it, and returns an `ActionType.Result`. The callback runs as a task of the executor. A callback that
        blocks needs a MultiThreadedExecutor and a ReentrantCallbackGroup; otherwise, cancel requests wait for the callback.
    :param goal_callback: accepts or rejects a goal; by default, every goal is accepted.
    :param handle_accepted_callback: handles an accepted goal; by default, the goal is executed.
    :param cancel_callback: accepts or rejects a cancel request; by default, every request is rejected.
    :param result_timeout: how long the result of a finished goal is stored, in seconds.
    """

    def __init__(
        self,
        node: Node,
        action_type: Any,
        action_name: str,
        execute_callback: Callable[[ServerGoalHandle], Any],
        *,
        callback_group: CallbackGroup | None = None,
        goal_callback: Callable[[Any], Any] = default_goal_callback,
        handle_accepted_callback: Callable[[ServerGoalHandle], Any] = default_handle_accepted_callback,
        cancel_callback: Callable[[Any], Any] = default_cancel_callback,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_pub_qos_profile: QoSProfile | int = 10,
        status_pub_qos_profile: QoSProfile = qos_profile_action_status_default,
        result_timeout: float = 900,
    ) -> None:
        super().__init__(callback_group or node.default_callback_group)
        check_is_valid_action_type(action_type)
        self._name = checked_action_name(core_of(node), action_name, 'server')
        self._node = node
        self._action_type = action_type
        self._logger = node.get_logger().get_child('action_server')
        self.register_goal_callback(goal_callback)
        self.register_cancel_callback(cancel_callback)
        self.register_handle_accepted_callback(handle_accepted_callback)
        self.register_execute_callback(execute_callback)
        self._result_timeout_ns = int(result_timeout * 1e9)
        self._goals: dict[bytes, ServerGoalHandle] = {}
        self._result_futures: dict[bytes, Future] = {}
        node.add_waitable(self)
        self.callback_group.add_entity(self)
        impl = action_type.Impl
        self._goal_service = self._serve('send_goal', impl.SendGoalService, goal_service_qos_profile)
        self._cancel_service = self._serve('cancel_goal', impl.CancelGoalService, cancel_service_qos_profile)
        self._result_service = self._serve('get_result', impl.GetResultService, result_service_qos_profile)
        self._feedback = self._advertise('feedback', impl.FeedbackMessage, validate_qos(feedback_pub_qos_profile))
        self._status = self._advertise('status', impl.GoalStatusMessage, status_pub_qos_profile)

    def get_num_entities(self) -> NumberOfEntities:
        """Return the number of entities of each kind that belong to this server."""
        return NumberOfEntities(num_timers=1, num_services=3)

    def _serve(self, part: str, srv_type: Any, qos: QoSProfile) -> ServiceServer:
        core = core_of(self._node)
        name = core.resolve(f'{self._name}/_action/{part}', 'service')
        return core.graph.create_service(core.entry, name, srv_type, engine_qos(qos), self.rcl_signal)

    def _advertise(self, part: str, msg_type: Any, qos: QoSProfile) -> Any:
        core = core_of(self._node)
        name = core.resolve(f'{self._name}/_action/{part}', 'topic')
        return core.graph.create_publisher(core.entry, name, msg_type, engine_qos(qos))

    action_type: ReadOnly[Any] = ReadOnly('The class of the action.', '_action_type')

    @property
    def _goal_handles(self) -> dict[bytes, ServerGoalHandle]:
        """The stored goals, by ID."""
        self._forget_old_goals()
        return self._goals

    def register_handle_accepted_callback(self, handle_accepted_callback: Callable[[ServerGoalHandle], Any] | None) -> None:
        """Set the callback for accepted goals. None means that the server executes them immediately."""
        self._handle_accepted_callback = handle_accepted_callback or default_handle_accepted_callback

    def register_goal_callback(self, goal_callback: Callable[[Any], Any] | None) -> None:
        """Set the callback that accepts or rejects goals. None means that the server accepts all goals."""
        self._goal_callback = goal_callback or default_goal_callback

    def register_cancel_callback(self, cancel_callback: Callable[[Any], Any] | None) -> None:
        """Set the callback that accepts or rejects cancel requests. None means that the server rejects all requests."""
        self._cancel_callback = cancel_callback or default_cancel_callback

    def register_execute_callback(self, execute_callback: Callable[[ServerGoalHandle], Any]) -> None:
        """Set the callback that executes goals. Raise TypeError if the callback is not callable."""
        if not callable(execute_callback):
            raise TypeError('Failed to register goal execution callback: not callable')
        self._execute_callback = execute_callback

    def rcl_run_callback(self, executor: ExecutorProtocol) -> Any:
        """Process at most one goal, one cancel request and one result request per turn, as rclpy does."""
        self.queued = False
        taken = [
            (answer, service.take())
            for service, answer in (
                (self._goal_service, self._answer_goal),
                (self._cancel_service, self._answer_cancel),
                (self._result_service, self._answer_result),
            )
        ]
        if self._goal_service.queue or self._cancel_service.queue or self._result_service.queue:
            self.rcl_signal()
        self._forget_old_goals()
        return self._answer_all(taken)

    async def _answer_all(self, taken: list[tuple[Callable[..., Any], Any]]) -> None:
        for answer, request in taken:
            if request is not None:
                await answer(*request)

    async def _answer_goal(self, wire: Any, request_id: RequestId) -> None:
        service = self._action_type.Impl.SendGoalService
        request = service.Request.from_wire(wire)
        goal_uuid = bytes(request.goal_id.uuid)
        response = service.Response()
        if goal_uuid not in self._goal_handles:
            verdict = await await_or_execute(self._goal_callback, request.goal)
            if not isinstance(verdict, GoalResponse):
                self._logger.warning('Goal request callback did not return a GoalResponse type. Rejecting goal.')
                from rclpy.impl.facts import note_no_goal_response

                note_no_goal_response(self._node, self._goal_callback, verdict)
            response.accepted = verdict == GoalResponse.ACCEPT
        if not response.accepted:
            self._goal_service.respond(request_id, service.Response.to_wire(response))
            return
        response.stamp = self._node.get_clock().now().to_msg()
        goal_handle = ServerGoalHandle(self, request.goal_id, response.stamp, request.goal)
        self._goals[goal_uuid] = goal_handle
        self._result_futures[goal_uuid] = Future()
        self.rcl_goal_changed()
        self._goal_service.respond(request_id, service.Response.to_wire(response))
        await await_or_execute(self._handle_accepted_callback, goal_handle)

    async def _answer_cancel(self, wire: Any, request_id: RequestId) -> None:
        service = self._action_type.Impl.CancelGoalService
        request = service.Request.from_wire(wire)
        response = service.Response()
        for goal_handle in self._goals_to_cancel(request.goal_info, response):
            verdict = await await_or_execute(self._cancel_callback, goal_handle)
            if verdict == CancelResponse.ACCEPT and goal_handle.is_active:
                goal_handle._update_state(GoalEvent.CANCEL_GOAL)
                response.goals_canceling.append(goal_info(goal_handle))
        self._cancel_service.respond(request_id, service.Response.to_wire(response))

    def _goals_to_cancel(self, info: Any, response: Any) -> list[ServerGoalHandle]:
        """Return the goals that a cancel request selects: one goal by its ID, or all goals up to a time.

        If the request contains neither an ID nor a time, return all goals that can be cancelled.
        """
        goal_uuid = bytes(info.goal_id.uuid)
        limit = (info.stamp.sec, info.stamp.nanosec)
        stoppable = [goal for goal in self._goals.values() if goal.status in (GoalState.ACCEPTED, GoalState.EXECUTING)]
        if any(goal_uuid) and limit == (0, 0):
            goal = self._goal_handles.get(goal_uuid)
            if goal is None:
                response.return_code = response.ERROR_UNKNOWN_GOAL_ID
            elif goal not in stoppable:
                response.return_code = response.ERROR_GOAL_TERMINATED
            return [goal] if goal in stoppable and goal is not None else []
        return [goal for goal in stoppable if limit == (0, 0) or bytes(goal.goal_id.uuid) == goal_uuid or stamp_of(goal) <= limit]

    async def _answer_result(self, wire: Any, request_id: RequestId) -> None:
        service = self._action_type.Impl.GetResultService
        goal_uuid = bytes(service.Request.from_wire(wire).goal_id.uuid)
        future = self._result_futures.get(goal_uuid)
        if future is None:
            self._result_service.respond(request_id, service.Response.to_wire(service.Response()))
            return
        future.add_done_callback(lambda done: self._result_service.respond(request_id, service.Response.to_wire(done.result())))

    def notify_execute(self, goal_handle: ServerGoalHandle, execute_callback: Callable[[ServerGoalHandle], Any] | None) -> None:
        """Make the executor execute a goal, with `execute_callback` or else with the registered callback."""
        executor = self._node.executor
        if executor is not None:
            executor.create_task(self._execute_goal, execute_callback or self._execute_callback, goal_handle)

    def rcl_now_ns(self) -> int:
        """Return the time of the node's clock in nanoseconds."""
        return self._node.get_clock().rcl_now_ns()

    def rcl_send_feedback(self, goal_handle: ServerGoalHandle, feedback: Any) -> None:
        """Publish feedback for a goal. The errors are those of :meth:`ServerGoalHandle.publish_feedback`."""
        if not isinstance(feedback, self._action_type.Feedback):
            raise wrong_class(feedback, self._action_type, 'Feedback')
        if not self._node.context.ok():
            raise after_shutdown('Failed to publish feedback with an action server: publisher')
        message_class = self._action_type.Impl.FeedbackMessage
        if goal_handle.status != GoalState.UNKNOWN:
            self._feedback.publish(message_class.to_wire(message_class(goal_id=goal_handle.goal_id, feedback=feedback)))

    def notify_goal_done(self) -> None:
        """Record that a goal has ended, and drop the results whose `result_timeout` has passed.

        :raises RCLError: when the server was destroyed.
        """
        if self.destroyed:
            raise RCLError('Failed to notfiy action server of goal done: action server pointer is invalid')
        self._forget_old_goals()

    async def _execute_goal(self, execute_callback: Callable[[ServerGoalHandle], Any], goal_handle: ServerGoalHandle) -> None:
        goal_uuid = goal_handle.goal_id.uuid
        try:
            result = await await_or_execute(execute_callback, goal_handle)
        except Exception as error:
            result = self._action_type.Result()
            self._logger.error(f'Error raised in execute callback: {error}')
            self._print_traceback(error)
        if goal_handle.is_active:
            self._logger.warning(f'Goal state not set, assuming aborted. Goal ID: {goal_uuid}')
            goal_handle.abort()
        self._give_result(goal_handle, result)

    def _give_result(self, goal_handle: ServerGoalHandle, result: Any) -> None:
        """Reply to the requests for the result of a goal. Ignore the result if the goal already has one."""
        future = self._result_futures.get(bytes(goal_handle.goal_id.uuid))
        if future is not None and not future.rcl_ended:
            result_type = self._action_type.Result
            if not isinstance(result, result_type):
                try:  # the C layer reads the fields one by one, whatever the class is
                    result = result_type(**{name: getattr(result, name) for name in result_type.get_fields_and_field_types()})
                except AttributeError as error:
                    facts = {'action': self._name, 'wanted': self._action_type.__name__, 'returned': kind_of(result)}
                    raise with_facts(AttributeError(str(error)), 'programs.no-result', **facts) from None
            future.set_result(self._action_type.Impl.GetResultService.Response(status=goal_handle.status, result=result))

    def _print_traceback(self, error: Exception) -> None:
        from edulaunch.engine.processes.traceback_text import student_traceback

        text, place = student_traceback(error)
        current_process().write('stderr', text)
        at = {} if place is None else {'file': place.file, 'line': place.line}
        message = f'{type(error).__name__}: {error}'
        core = core_of(self._node)
        current_process().fact('goal failed', (core.entry.index, self._name), {'node': core.full_name, 'said': message, **at})

    def rcl_goal_changed(self) -> None:
        """Publish the states of all goals on the status topic."""
        message = self._action_type.Impl.GoalStatusMessage()
        message.status_list = [GoalStatus(goal_info=goal_info(goal), status=goal.status) for goal in self._goals.values()]
        self._status.publish(type(message).to_wire(message))

    def _forget_old_goals(self) -> None:
        """Drop the goals that ended at least `result_timeout` ago."""
        limit = self.rcl_now_ns() - self._result_timeout_ns
        for goal_uuid, goal in list(self._goals.items()):
            if has_ended_until(goal, limit):
                del self._goals[goal_uuid]
                del self._result_futures[goal_uuid]

    def destroy(self) -> None:
        """Stop serving the action."""
        if self.destroyed:
            return
        self._node.remove_waitable(self)
        for goal in self._goals.values():
            goal.destroy()
        for endpoint in (self._goal_service, self._cancel_service, self._result_service, self._feedback, self._status):
            endpoint.destroy()


__getattr__ = passed_on(__name__)
