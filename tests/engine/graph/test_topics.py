"""Delivery between publishers and subscriptions."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.qos import BEST_EFFORT, KEEP_ALL, TRANSIENT_LOCAL, QoS
from edulaunch.engine.graph.topics import Subscription
from edulaunch.engine.graph.tracer import Tracer
from edulaunch.engine.sim.simulation import Simulation


class Text:
    TYPE = 'test_msgs/msg/Text'


class Number:
    TYPE = 'test_msgs/msg/Number'


class Bench:
    """A graph with one node, and shortcuts that log who was told what."""

    def __init__(self, tracer: Tracer | None = None) -> None:
        self.graph = Graph(Simulation(), tracer)
        self.node = self.graph.add_node(None, 'node', '/')
        self.log: list[str] = []

    def publisher(self, qos: QoS = QoS(), cls: Any = Text) -> Any:
        return self.graph.create_publisher(self.node, '/chatter', cls, qos)

    def subscription(self, name: str = 'heard', qos: QoS = QoS(), cls: Any = Text) -> Subscription:
        return self.graph.create_subscription(self.node, '/chatter', cls, qos, lambda: self.log.append(name))


def texts(subscription: Subscription) -> list[Any]:
    return [wire for wire, *_ in subscription.queue]


def test_a_message_stands_in_every_queue_when_publish_returns() -> None:
    bench = Bench()
    publisher = bench.publisher()
    first, second = bench.subscription('first'), bench.subscription('second')
    publisher.publish(('hello',))
    assert bench.log == ['first', 'second']
    assert first.take() == (('hello',), bench.graph.sim.now_ns, publisher, 1)
    assert texts(second) == [('hello',)] and first.take() is None


@pytest.mark.parametrize(('qos', 'kept'), [(QoS(depth=2), [8, 9]), (QoS(depth=0), [9]), (QoS(history=KEEP_ALL), list(range(10)))])
def test_a_full_queue_drops_the_oldest(qos: QoS, kept: list[int]) -> None:
    bench = Bench()
    publisher, subscription = bench.publisher(), bench.subscription(qos=qos)
    for number in range(10):
        publisher.publish(number)
    assert texts(subscription) == kept


def test_late_transient_local_subscriptions_get_the_last_samples_and_volatile_ones_do_not() -> None:
    bench = Bench()
    publisher = bench.publisher(QoS(depth=2, durability=TRANSIENT_LOCAL))
    for number in range(4):
        publisher.publish(number)
    assert texts(bench.subscription('late', QoS(durability=TRANSIENT_LOCAL))) == [2, 3]
    assert texts(bench.subscription('may lose', QoS(durability=TRANSIENT_LOCAL, reliability=BEST_EFFORT))) == []
    assert texts(bench.subscription('volatile')) == []
    assert bench.log == ['late']


@pytest.mark.parametrize(('after_ns', 'kept'), [(0, [1]), (999, [1]), (1000, []), (1001, [])])
def test_a_late_subscription_gets_no_message_whose_lifespan_is_over(after_ns: int, kept: list[int]) -> None:
    bench = Bench()
    bench.publisher(QoS(durability=TRANSIENT_LOCAL, lifespan_ns=1000)).publish(1)
    bench.graph.sim.run(bench.graph.sim.now_ns + after_ns)
    assert texts(bench.subscription('late', QoS(durability=TRANSIENT_LOCAL))) == kept


def test_without_a_lifespan_a_message_never_ends() -> None:
    bench = Bench()
    bench.publisher(QoS(durability=TRANSIENT_LOCAL)).publish(1)
    bench.graph.sim.run(bench.graph.sim.now_ns + 10**15)
    assert texts(bench.subscription('late', QoS(durability=TRANSIENT_LOCAL))) == [1]


def test_incompatible_ends_do_not_talk_and_both_are_told() -> None:
    bench = Bench()
    publisher = bench.publisher(QoS(reliability=BEST_EFFORT))
    publisher.on_incompatible = lambda policy: bench.log.append(f'publisher {policy}')
    subscription = bench.subscription()
    publisher.publish('lost')
    assert (bench.log, texts(subscription), publisher.subscription_count) == (['publisher RELIABILITY'], [], 0)


def test_ends_of_different_types_never_match() -> None:
    bench = Bench()
    publisher = bench.publisher(cls=Number)
    text, number = bench.subscription('text'), bench.subscription('number', cls=Number)
    publisher.publish(1)
    assert (texts(text), texts(number), bench.log) == ([], [1], ['number'])


def test_a_destroyed_end_is_left_out() -> None:
    bench = Bench()
    publisher, gone, here = bench.publisher(), bench.subscription('gone'), bench.subscription('here')
    gone.destroy()
    gone.destroy()
    publisher.publish('x')
    assert (bench.log, publisher.subscription_count) == (['here'], 1)
    publisher.destroy()
    assert here.publisher_count == 0 and '/chatter' not in bench.graph.publishers


def test_matches_are_counted_up_and_down() -> None:
    bench = Bench()
    publisher, counts = bench.publisher(), []
    publisher.on_matched = counts.append
    bench.subscription().destroy()
    assert counts == [1, -1]


def test_removing_a_node_removes_its_ends() -> None:
    bench = Bench()
    publisher = bench.publisher()
    other = bench.graph.add_node(None, 'other', '/ns')
    bench.graph.create_subscription(other, '/chatter', Text, QoS(), lambda: None)
    assert other.fully_qualified_name == '/ns/other' and publisher.subscription_count == 1
    bench.graph.remove_node(other)
    bench.graph.remove_node(other)
    assert publisher.subscription_count == 0 and bench.graph.nodes == [bench.node]


def test_the_tracer_sees_a_publication_before_its_receivers() -> None:
    log: list[Any] = []

    class Watch(Tracer):
        def channel(self, publisher: Any) -> Any:
            return lambda record: log.append(('traced', record[2]))

    bench = Bench(Watch())
    bench.log = log
    publisher = bench.publisher()
    bench.subscription('told')
    publisher.publish('x')
    assert log == [('traced', 'x'), 'told']


def test_every_coming_and_going_counts_as_a_change() -> None:
    bench = Bench()
    seen: list[int] = []
    bench.graph.on_change.append(lambda: seen.append(bench.graph.changes))
    bench.publisher().destroy()
    assert seen == [2, 3]
