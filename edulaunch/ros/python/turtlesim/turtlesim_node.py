"""The program turtlesim_node, a window of turtles that is updated every 16 ms."""

from __future__ import annotations

from typing import Any

import rclpy
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclcpp_like import CppNode, program
from rclpy.executors import SingleThreadedExecutor
from std_srvs.srv import Empty

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.task import current_task
from edulaunch.engine.worlds.turtle import Turtle
from edulaunch.engine.worlds.turtle_world import TurtleWorld
from turtlesim.srv import Kill, Spawn
from turtlesim.turtle_ports import TurtlePorts

BACKGROUND = (('background_r', 'Red', 69), ('background_g', 'Green', 86), ('background_b', 'Blue', 255))


class TurtleFrame:
    """The node of the turtle window. All names are relative, so that a namespace changes them."""

    def __init__(self) -> None:
        self.node = CppNode('turtlesim')
        self._log = self.node.get_logger()
        self._clock = self.node.get_clock()
        self._started = False
        process = current_process()
        self._world = TurtleWorld(process.sim.random(f'turtlesim pictures {process.name}'))
        self._ports: dict[str, TurtlePorts] = {}
        self._in_order: list[TurtlePorts] = []
        self._declare_parameters()
        self.node.create_service(Empty, 'clear', self._on_clear)
        self.node.create_service(Empty, 'reset', self._on_reset)
        self.node.create_service(Spawn, 'spawn', self._on_spawn)
        self.node.create_service(Kill, 'kill', self._on_kill)
        self._log.info(f'Starting turtlesim with node name {self.node.get_fully_qualified_name()}')
        self._welcome(self._world.spawn_first())

    def _declare_parameters(self) -> None:
        channel = IntegerRange(from_value=0, to_value=255, step=1)
        for name, color, value in BACKGROUND:
            self.node.declare_parameter(
                name, value, ParameterDescriptor(description=f'{color} channel of the background color', integer_range=[channel])
            )
        self.node.declare_parameter(
            'holonomic', False, ParameterDescriptor(description='If true, then turtles will be holonomic')
        )

    def update(self) -> None:
        """Update all turtles once. Change no turtle while the clock shows 0, and in the first update after that."""
        now_ns = self._clock.rcl_now_ns()
        if not self._started:
            self._started = now_ns != 0
            return
        for ports in self._in_order:
            ports.update(now_ns)

    def _welcome(self, turtle: Turtle) -> None:
        self._ports[turtle.name] = TurtlePorts(self.node, turtle)
        self._order()
        place = f'x=[{turtle.x:f}], y=[{turtle.y:f}], theta=[{turtle.theta:f}]'
        self._log.info(f'Spawning turtle [{turtle.name}] at {place}')

    def _order(self) -> None:
        self._in_order = [self._ports[turtle.name] for turtle in self._world.turtles]

    def _on_clear(self, request: Any, response: Any) -> Any:
        self._log.info('Clearing turtlesim.')
        self._world.clear()
        return response

    def _on_reset(self, request: Any, response: Any) -> Any:
        self._log.info('Resetting turtlesim.')
        for ports in self._in_order:
            ports.destroy()
        self._ports.clear()
        self._world.remove_all()
        self._welcome(self._world.spawn_first())
        self._world.clear()
        return response

    def _on_spawn(self, request: Any, response: Any) -> Any:
        turtle = self._world.spawn(request.x, request.y, request.theta, request.name)
        if turtle is None:
            self._log.error(f'A turtle named [{request.name}] already exists')
        else:
            self._welcome(turtle)
            response.name = turtle.name
        return response

    def _on_kill(self, request: Any, response: Any) -> Any:
        if self._world.kill(request.name):
            self._ports.pop(request.name).destroy()
            self._order()
        else:
            self._log.error(f'Tried to kill turtle [{request.name}], which does not exist')
        return response


TICK_NS = 16_000_000


def run() -> None:
    """In each tick, process the ROS callbacks that are ready, without waiting, and then update all turtles."""
    frame = TurtleFrame()
    executor = SingleThreadedExecutor()
    executor.add_node(frame.node)
    task = current_task()
    context = rclpy.get_default_context()
    tick_ns = task.sim.now_ns
    while True:
        tick_ns += TICK_NS
        task.sleep_until(tick_ns)
        if not context.alive:
            return
        executor.rcl_spin_ready()
        frame.update()


main = program(run)
