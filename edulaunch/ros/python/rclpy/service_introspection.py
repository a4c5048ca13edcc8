"""Service events, which contain the requests and replies of services and clients."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.impl.c_enum import Pybind11IntEnum
from rclpy.qos import QoSProfile, engine_qos

if TYPE_CHECKING:
    from edulaunch.engine.graph.services import RequestId
    from rclpy.impl.protocols import ClockProtocol

REQUEST_SENT, REQUEST_RECEIVED, RESPONSE_SENT, RESPONSE_RECEIVED = range(4)


class ServiceIntrospectionState(Pybind11IntEnum):
    """The parts of a service call that are published."""

    OFF = 0
    METADATA = 1
    CONTENTS = 2


class Introspection:
    """A publisher of the events of one service or client on `<service>/_service_event`."""

    def __init__(
        self, endpoint: Any, event_class: Any, clock: ClockProtocol, qos: QoSProfile, state: ServiceIntrospectionState
    ) -> None:
        self._client = endpoint
        self._clock = clock
        self._contents = state == ServiceIntrospectionState.CONTENTS
        self._event_class = event_class
        self._publisher = endpoint.graph.create_publisher(
            endpoint.node, f'{endpoint.service_name}/_service_event', event_class, engine_qos(qos)
        )

    def stop(self) -> None:
        """Stop publishing service events."""
        self._publisher.destroy()

    def request_sent(self, sequence: int, request: Any) -> None:
        """Publish the event that the client has sent a request."""
        self._publish(REQUEST_SENT, self._client, sequence, 'request', request)

    def response_received(self, sequence: int, response: Any) -> None:
        """Publish the event that the client has received a reply."""
        self._publish(RESPONSE_RECEIVED, self._client, sequence, 'response', response)

    def request_received(self, request_id: RequestId, request: Any) -> None:
        """Publish the event that the service has received a request."""
        self._publish(REQUEST_RECEIVED, *request_id, 'request', request)

    def response_sent(self, request_id: RequestId, response: Any) -> None:
        """Publish the event that the service has sent a reply."""
        self._publish(RESPONSE_SENT, *request_id, 'response', response)

    def _publish(self, kind: int, client: Any, sequence: int, field: str, content: Any) -> None:
        event = self._event_class()
        event.info.event_type = kind
        event.info.stamp = self._clock.now().to_msg()
        event.info.client_gid = list(client.index.to_bytes(16, 'big'))
        event.info.sequence_number = sequence
        if self._contents:
            setattr(event, field, [content])
        self._publisher.publish(self._event_class.to_wire(event))
