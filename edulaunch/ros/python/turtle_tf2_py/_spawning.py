"""A node that first spawns another turtle, one step each second."""

from __future__ import annotations

from typing import Any

from rclpy.node import Node
from turtlesim.srv import Spawn


class SpawningNode(Node):
    """Spawns a turtle at (4, 2, 0). Each second, it does one step: send the request, read the reply, and then call `on_step`."""

    def __init__(self, node_name: str, turtle: str) -> None:
        super().__init__(node_name)
        self._turtle = turtle
        self._spawned = False
        self._reply: Any = None
        self._spawner = self.create_client(Spawn, 'spawn')
        self._timer = self.create_timer(1.0, self._on_timer)

    def on_step(self) -> None:
        """Do the work of the node. The node calls this method every second once the turtle exists."""

    def _on_timer(self) -> None:
        if self._spawned:
            self.on_step()
        elif self._reply is not None:
            self._look_at_reply()
        elif self._spawner.service_is_ready():
            self._reply = self._spawner.call_async(Spawn.Request(x=4.0, y=2.0, theta=0.0, name=self._turtle))
        else:
            self.get_logger().info('Service is not ready')

    def _look_at_reply(self) -> None:
        if self._reply.done():
            self.get_logger().info(f'Successfully spawned {self._reply.result().name}')
            self._spawned = True
        else:
            self.get_logger().info('Spawn is not finished')
