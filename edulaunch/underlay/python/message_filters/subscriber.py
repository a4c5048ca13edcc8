"""Where messages enter a chain of filters."""

from __future__ import annotations

from typing import Any

from message_filters.simple_filter import SimpleFilter


class Subscriber(SimpleFilter):
    """A subscription as a filter: `Subscriber(node, MessageType, 'topic')`.

    Further arguments go to `Node.create_subscription`; `qos_profile` is 10 when left out.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__()
        self.node = args[0]
        self.topic: str = args[2]
        kwargs.setdefault('qos_profile', 10)
        self.sub = self.node.create_subscription(*args[1:], self.callback, **kwargs)

    def callback(self, msg: Any) -> None:
        """Let a message pass."""
        self.signalMessage(msg)

    def getTopic(self) -> str:
        """The topic, as it was given."""
        return self.topic

    def __getattr__(self, key: str) -> Any:
        """Everything else is asked of the subscription."""
        if key == 'sub':
            raise AttributeError(key)
        return getattr(self.sub, key)
