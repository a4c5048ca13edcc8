"""Services of nodes."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import kind_of, with_facts
from edulaunch.ros.passed_on import passed_on
from rclpy.impl.entity import SERVICE, Entity, ReadyList, ServiceEnd
from rclpy.task import is_coroutine_function

if TYPE_CHECKING:
    from edulaunch.engine.graph.services import RequestId, ServiceServer
    from rclpy.callback_groups import CallbackGroup
    from rclpy.impl.protocols import ExecutorProtocol
    from rclpy.qos import QoSProfile


class Service(ServiceEnd, Entity):
    """A service of a node, created by `Node.create_service`. The callback receives (request, response) and returns
    the response.
    """

    rcl_category = SERVICE
    endpoint: ServiceServer

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
        self.rcl_is_async = is_coroutine_function(callback)

    def rcl_run_callback(self, executor: ExecutorProtocol) -> Any:
        self.queued = False
        queue = self.endpoint.queue
        if not queue:
            return None
        wire, request_id = queue.popleft()
        if queue:
            self.rcl_signal()
        request = self.srv_type.Request.from_wire(wire)
        if self._introspection is not None:
            self._introspection.request_received(request_id, request)
        response = self.callback(request, self.srv_type.Response())
        if self.rcl_is_async:
            return self._answer_later(response, request_id)
        self.send_response(response, request_id)
        return None

    async def _answer_later(self, coroutine: Any, request_id: RequestId) -> None:
        self.send_response(await coroutine, request_id)

    def send_response(self, response: Any, header: RequestId) -> None:
        """Reply to one request.

        :raises TypeError: when `response` is not a response of this service, for example after a callback without `return
            response`.
        """
        response_type = self.srv_type.Response
        if not isinstance(response, response_type):
            raise with_facts(TypeError(), 'programs.no-response', service=self.endpoint.service_name, returned=kind_of(response))
        self.endpoint.respond(header, response_type.to_wire(response))
        if self._introspection is not None:
            self._introspection.response_sent(header, response)

    def destroy(self) -> None:
        """Destroy the service. Prefer `Node.destroy_service`."""
        self.destroyed = True
        self.endpoint.destroy()


__getattr__ = passed_on(__name__)
