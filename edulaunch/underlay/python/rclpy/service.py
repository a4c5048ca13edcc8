"""Answering service calls."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy.impl.handle import Handle, check_alive, handle_of, logger_name_of
from rclpy.impl.passed_on import passed_on
from rclpy.readiness import SERVICE, Entity, ReadyList
from rclpy.task import is_coroutine_function

if TYPE_CHECKING:
    from edulaunch.graph.services import RequestId, ServiceServer
    from rclpy.callback_groups import CallbackGroup
    from rclpy.clock import Clock
    from rclpy.executors import Executor
    from rclpy.qos import QoSProfile
    from rclpy.service_introspection import ServiceIntrospectionState


class Service(Entity):
    """Made by `Node.create_service`. The callback gets (request, response) and returns the response."""

    category = SERVICE

    def __init__(
        self,
        ready_list: ReadyList,
        srv_type: Any,
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        callback_group: CallbackGroup,
        qos_profile: QoSProfile,
        number: int,
    ) -> None:
        super().__init__(ready_list, callback_group, number)
        self.srv_type = srv_type
        self.srv_name = srv_name
        self.callback = callback
        self.qos_profile = qos_profile
        self.is_async = is_coroutine_function(callback)
        self._introspection: Any = None
        self._impl: ServiceServer

    def _connect(self, impl: ServiceServer) -> None:
        self._impl = impl

    def _run(self, executor: Executor) -> Any:
        self._queued = False
        queue = self._impl.queue
        if not queue:
            return None
        wire, request_id = queue.popleft()
        if queue:
            self._signal()
        request = self.srv_type.Request.from_wire(wire)
        if self._introspection is not None:
            self._introspection.request_received(request_id, request)
        response = self.callback(request, self.srv_type.Response())
        if self.is_async:
            return self._answer_later(response, request_id)
        self.send_response(response, request_id)
        return None

    async def _answer_later(self, coroutine: Any, request_id: RequestId) -> None:
        self.send_response(await coroutine, request_id)

    def send_response(self, response: Any, header: RequestId) -> None:
        """Answer one request.

        :raises TypeError: when `response` is no response of this service (a callback that forgot `return response`).
        """
        response_type = self.srv_type.Response
        if not isinstance(response, response_type):
            from rclpy.impl.hints import hinted

            returned = 'None' if response is None else f'a {type(response).__name__}'
            raise hinted(
                TypeError(),
                f"the callback of service '{self._impl.service_name}' must end with `return response`; it returned {returned}",
            )
        self._impl.respond(header, response_type.to_wire(response))
        if self._introspection is not None:
            self._introspection.response_sent(header, response)

    @property
    def service_name(self) -> str:
        """The service's absolute name, after remapping. Raises InvalidHandle when destroyed."""
        check_alive(self._impl)
        return self._impl.service_name

    @property
    def logger_name(self) -> str:
        """The name of its node's logger. Raises InvalidHandle when destroyed."""
        return logger_name_of(self._impl)

    @property
    def handle(self) -> Handle:
        """What holds the endpoint in the graph."""
        return handle_of(self._impl)

    def configure_introspection(
        self, clock: Clock, service_event_qos_profile: QoSProfile, introspection_state: ServiceIntrospectionState
    ) -> None:
        """Publish what is received and answered on `<service>/_service_event`."""
        from rclpy.service_introspection import Introspection

        self._introspection = Introspection.configured(self, clock, service_event_qos_profile, introspection_state)

    def destroy(self) -> None:
        """Stop answering. `Node.destroy_service` is the better way."""
        self._destroyed = True
        self._impl.destroy()


__getattr__ = passed_on(__name__)
