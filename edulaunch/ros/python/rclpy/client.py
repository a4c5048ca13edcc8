"""Clients of services, and the common part of service and action clients."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.sim.task import current_task
from edulaunch.ros.passed_on import passed_on
from rclpy.impl.entity import CLIENT, Entity, ReadyList, ServiceEnd, check_alive, check_endpoint
from rclpy.impl.refusals import invalid_handle
from rclpy.task import Future, future_answer
from rclpy.type_support import wrong_class

if TYPE_CHECKING:
    from edulaunch.engine.graph.services import ServiceClient
    from rclpy.callback_groups import CallbackGroup
    from rclpy.context import Context
    from rclpy.impl.protocols import ExecutorProtocol
    from rclpy.qos import QoSProfile

POLL_NS = 250_000_000
"""The period of the checks of `wait_for_service`: 0.25 s, as in rclpy."""


class Asker(Entity):
    """The common part of service and action clients.

    Such a client waits for servers and replies, and records deadlocks and long waits as facts.
    """

    _waited_ns = 0

    def rcl_asked(self) -> tuple[ServiceClient, str, str]:
        """Return the endpoint of the client, the name of its service or action, and the word 'service' or 'action'."""
        raise NotImplementedError

    def rcl_awaited(self) -> dict[str, str]:
        """Return a description of the awaited service or action, for use in a fact."""
        _, name, kind = self.rcl_asked()
        return {'name': name, 'kind': kind}

    def rcl_node_name(self) -> str:
        """Return the full name of the client's node."""
        return self.rcl_asked()[0].node.fully_qualified_name

    def rcl_note_deadlock(self) -> None:
        """Record a deadlock if the running callback waits for a response that cannot arrive during this wait."""
        executor = self.ready_list.executor
        if executor is not None and executor.rcl_cannot_serve(self):
            from rclpy.impl.facts import note_wait

            note_wait('call', self)

    def rcl_await_server(self, context: Context, is_ready: Callable[[], bool], timeout_sec: float | None) -> None:
        """Check every 0.25 s whether a server exists, as rclpy does. Record a long wait as a fact."""
        while_looking(context, is_ready, timeout_sec, lambda: self._watch_wait(is_ready))

    def _watch_wait(self, is_ready: Callable[[], bool]) -> None:
        from rclpy.impl.facts import LONG_NS, note_long_wait, note_server_came

        self._waited_ns += POLL_NS
        endpoint, name, kind = self.rcl_asked()
        if is_ready():
            note_server_came(endpoint, name)
        elif self._waited_ns == LONG_NS:
            note_long_wait(endpoint, name, kind)


def while_looking(
    context: Context, is_ready: Callable[[], bool], timeout_sec: float | None, looked: Callable[[], object] = lambda: None
) -> None:
    """Check every 0.25 s until the condition is true, the timeout has passed or the context is shut down.

    :param timeout_sec: the timeout in simulated seconds; None means no limit.
    :param looked: called after each wait.
    """
    left = float('inf') if timeout_sec is None else timeout_sec
    task = current_task()
    while context.alive and not is_ready() and left > 0.0:
        task.sleep_until(task.sim.now_ns + POLL_NS)
        left -= POLL_NS / 1e9
        looked()


def parked_until_done(future: Future, timeout_sec: float | None = None) -> bool:
    """Wait until a future is done, and return whether it is done. Another thread must spin.

    :param timeout_sec: the longest wait in simulated seconds; None means no limit.
    """
    task = current_task()
    future.add_done_callback(lambda _: task.wake())
    deadline = None if timeout_sec is None else task.sim.now_ns + int(timeout_sec * 1e9)
    while not future.rcl_ended:
        if not task.park(deadline) and not future.rcl_ended:
            return False
    return True


class Client(ServiceEnd, Asker):
    """A client of a service, created by `Node.create_client`."""

    rcl_category = CLIENT
    endpoint: ServiceClient

    def __init__(
        self,
        context: Context,
        ready_list: ReadyList,
        srv_type: Any,
        srv_name: str,
        qos_profile: QoSProfile,
        callback_group: CallbackGroup,
        number: int,
    ) -> None:
        super().__init__(ready_list, callback_group, number)
        self.context = context
        self.srv_type = srv_type
        self.srv_name = srv_name
        self.qos_profile = qos_profile
        self._pending_requests: dict[int, Future] = {}
        self._lost_recorded = False

    def call(self, request: Any, timeout_sec: float | None = None) -> Any:
        """Send a request and wait for the reply. Another thread must spin. Inside a callback, this call waits forever.

        :param timeout_sec: the longest wait in simulated seconds. When it has passed, the method returns None, as in Jazzy.
        :raises TypeError: for a request of another class.
        """
        self._check_request(request)
        if timeout_sec is None:
            self.rcl_note_deadlock()
        future = self.call_async(request)
        if not parked_until_done(future, timeout_sec):
            self.remove_pending_request(future)
            return None
        return future.result()

    def rcl_asked(self) -> tuple[ServiceClient, str, str]:
        """Return the client's endpoint, the name of the service, and the word 'service'."""
        return self.endpoint, self.endpoint.service_name, 'service'

    def call_async(self, request: Any) -> Future:
        """Send a request. The result of the future is the reply. Without a server, the request is lost.

        :raises TypeError: for a request of another class.
        """
        self._check_request(request)
        if self.destroyed:
            raise invalid_handle()
        impl = self.endpoint
        sequence = impl.send(self.srv_type.Request.to_wire(request))
        if impl.lost and not self._lost_recorded:
            self._note_lost_request()
        future = future_answer(self)
        future.add_done_callback(self.remove_pending_request)
        self._pending_requests[sequence] = future
        if self._introspection is not None:
            self._introspection.request_sent(sequence, request)
        return future

    def _note_lost_request(self) -> None:
        self._lost_recorded = True
        from rclpy.impl.facts import note_lost_request

        note_lost_request(self.endpoint, self.endpoint.service_name, 'service')

    def _check_request(self, request: Any) -> None:
        if not isinstance(request, self.srv_type.Request):
            raise wrong_class(request, self.srv_type, 'Request')

    def rcl_run_callback(self, executor: ExecutorProtocol) -> Any:
        self.queued = False
        queue = self.endpoint.queue
        if not queue:
            return None
        sequence, wire = queue.popleft()
        if queue:
            self.rcl_signal()
        response = self.srv_type.Response.from_wire(wire)
        if self._introspection is not None:
            self._introspection.response_received(sequence, response)
        future = self._pending_requests.get(sequence)
        if future is not None:
            future._set_executor(executor)
            future.set_result(response)
        return None

    def get_pending_request(self, sequence_number: int) -> Future:
        """Return the future of a request whose reply has not arrived. Requests are numbered from 1.

        :raises KeyError: when no such request waits for a reply.
        """
        return self._pending_requests[sequence_number]

    def remove_pending_request(self, future: Future) -> None:
        """Remove a request, and ignore a later reply to it."""
        for sequence, pending in self._pending_requests.items():
            if pending is future:
                del self._pending_requests[sequence]
                break

    def service_is_ready(self) -> bool:
        """Return whether a server exists. Raise InvalidHandle after destroy, and RCLError after shutdown."""
        check_endpoint(self.endpoint, self.context, 'failed to check service availability: rcl node')
        current_task().poll()
        return self.endpoint.server_is_ready()

    def wait_for_service(self, timeout_sec: float | None = None) -> bool:
        """Wait for a server, checking every 0.25 s as rclpy does. Return whether a server exists.

        :param timeout_sec: the longest wait in simulated seconds; None means no limit.
        """
        check_alive(self.endpoint)
        self.rcl_await_server(self.context, self.endpoint.server_is_ready, timeout_sec)
        return self.service_is_ready()

    def destroy(self) -> None:
        """Destroy the client. Prefer `Node.destroy_client`."""
        self.destroyed = True
        self.endpoint.destroy()


__getattr__ = passed_on(__name__)
