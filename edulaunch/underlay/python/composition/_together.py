"""Several components in one program, without a container."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

from rclcpp_like import run_program
from rclpy.executors import SingleThreadedExecutor

from composition.client import Client
from composition.listener import Listener
from composition.server import Server
from composition.talker import Talker

LIBRARIES: dict[str, Callable[..., Any]] = {
    'libtalker_component.so': Talker,
    'liblistener_component.so': Listener,
    'libserver_component.so': Server,
    'libclient_component.so': Client,
}


def run_together(makers: list[Callable[..., Any]]) -> None:
    """Make the nodes in this order and let one executor spin them."""

    def body() -> None:
        executor = SingleThreadedExecutor()
        for maker in makers:
            executor.add_node(maker())
        executor.spin()

    sys.exit(run_program(body))
