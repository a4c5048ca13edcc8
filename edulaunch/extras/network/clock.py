"""Publish the time of a machine on /clock for nodes with `use_sim_time`, on the machine and on the network."""

from __future__ import annotations

from types import SimpleNamespace

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.interfaces.registry import underlay_registry

PERIOD_NS = 10_000_000
NAME = 'machine_clock'


class ClockNode:
    """A node that publishes the time a hundred times a second until it is stopped."""

    def __init__(self, graph: Graph) -> None:
        self._graph = graph
        self._node = graph.add_node(SimpleNamespace(name=NAME, pid=0, state={}), NAME, '/')
        cls = underlay_registry().get('rosgraph_msgs/msg/Clock')
        self._publisher = graph.create_publisher(self._node, '/clock', cls, QoS(depth=1))
        self._tick()

    def _tick(self) -> None:
        if not self._publisher.destroyed:
            sim = self._graph.sim
            self._publisher.publish(divmod(sim.now_ns, 10**9))
            sim.schedule(sim.now_ns + PERIOD_NS, self._tick)

    def stop(self) -> None:
        """Remove the node from the graph."""
        self._graph.remove_node(self._node)
