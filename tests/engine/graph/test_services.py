"""Requests and replies."""

from __future__ import annotations

from typing import Any

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.sim.simulation import Simulation


class Add:
    TYPE = 'test_srvs/srv/Add'


class Other:
    TYPE = 'test_srvs/srv/Other'


def bench() -> tuple[Graph, Any, list[str]]:
    graph, log = Graph(Simulation()), []
    return graph, graph.add_node(None, 'node', '/'), log


def server(graph: Graph, node: Any, log: list[str], name: str = 'server', cls: Any = Add) -> Any:
    return graph.create_service(node, '/add', cls, QoS(), lambda: log.append(name))


def client(graph: Graph, node: Any, log: list[str]) -> Any:
    return graph.create_client(node, '/add', Add, QoS(), lambda: log.append('client'))


def test_a_reply_goes_to_who_asked_with_its_number() -> None:
    graph, node, log = bench()
    serving, one, two = server(graph, node, log), client(graph, node, log), client(graph, node, log)
    assert (one.send((1, 2)), two.send((3, 4)), one.send((5, 6))) == (1, 1, 2)
    while (taken := serving.take()) is not None:
        wire, request_id = taken
        serving.respond(request_id, (sum(wire),))
    assert [one.take(), one.take(), one.take()] == [(1, (3,)), (2, (11,)), None]
    assert two.take() == (1, (7,))
    assert log == ['server'] * 3 + ['client'] * 3


def test_without_a_server_a_request_is_lost() -> None:
    graph, node, log = bench()
    asking = client(graph, node, log)
    assert not asking.server_is_ready() and asking.send((1, 2)) == 1
    assert server(graph, node, log).take() is None and asking.server_is_ready()


def test_all_servers_of_one_name_get_a_request_and_the_first_reply_counts() -> None:
    graph, node, log = bench()
    first, second, asking = server(graph, node, log, 'first'), server(graph, node, log, 'second'), client(graph, node, log)
    asking.send(())
    for serving in (second, first):
        serving.respond(serving.take()[1], (serving is second,))
    assert (asking.take(), asking.take()) == ((1, (True,)), None)
    first.destroy()
    asking.send(())
    assert log == ['first', 'second', 'client', 'second']


def test_a_server_of_another_type_is_no_server() -> None:
    graph, node, log = bench()
    server(graph, node, log, cls=Other)
    assert not client(graph, node, log).server_is_ready()


def test_a_reply_to_a_client_that_is_gone_is_dropped() -> None:
    graph, node, log = bench()
    serving, asking = server(graph, node, log), client(graph, node, log)
    asking.send(())
    asking.destroy()
    serving.respond(serving.take()[1], ())
    assert log == ['server']
