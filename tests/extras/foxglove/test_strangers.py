"""Clients that mean no good, on a machine: whatever they say in whatever order, the machine and its other clients continue."""

from __future__ import annotations

import json
import struct
from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.extras.foxglove.conversation import Conversation, TooMuch
from edulaunch.extras.foxglove.live import LiveFeed
from edulaunch.runtime.session import Session
from tests.extras.foxglove.feeds import Machine, Spoken

numbers = st.integers(0, 40)
topics = st.sampled_from(['/turtle1/cmd_vel', '/turtle1/pose', '/tf', 'x', '/a b', ''])
types = st.sampled_from(
    ['geometry_msgs/msg/Twist', 'turtlesim/msg/Pose', 'tf2_msgs/msg/TFMessage', 'std_msgs/msg/Empty', 'a/b', '']
)
parameters = st.sampled_from(
    ['/turtlesim.background_r', '/turtlesim.holonomic', '/turtlesim.use_sim_time', '/turtlesim.', '.', '']
)
values = st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5)
cdr = st.binary(max_size=60).map(lambda data: b'\x00\x01\x00\x00' + data) | st.binary(max_size=8)

fields = st.dictionaries(
    st.sampled_from(['linear', 'x', 'theta', 'transforms', 'data']),
    st.recursive(
        values,
        lambda inner: st.lists(inner, max_size=2) | st.dictionaries(st.sampled_from(['x', 'y', 'header']), inner, max_size=2),
    ),
    max_size=2,
)


def op(name: str, **fields: st.SearchStrategy[Any]) -> st.SearchStrategy[str]:
    return st.fixed_dictionaries({'op': st.just(name), **fields}).map(json.dumps)


def several(**fields: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    return st.lists(st.fixed_dictionaries(fields), max_size=3)


words = st.one_of(
    op('subscribe', subscriptions=several(id=numbers, channelId=numbers)),
    op('unsubscribe', subscriptionIds=st.lists(numbers, max_size=3)),
    op('advertise', channels=several(id=numbers, topic=topics, encoding=st.sampled_from(['cdr', 'json']), schemaName=types)),
    op('unadvertise', channelIds=st.lists(numbers, max_size=3)),
    op('getParameters', parameterNames=st.lists(parameters, max_size=3)),
    op('setParameters', parameters=several(name=parameters, value=values | st.lists(values, max_size=3)), id=st.text(max_size=3)),
    op('subscribeParameterUpdates', parameterNames=st.lists(parameters, max_size=3)),
    op('unsubscribeParameterUpdates', parameterNames=st.lists(parameters, max_size=3)),
    st.sampled_from(['{"op":"subscribeConnectionGraph"}', '{"op":"unsubscribeConnectionGraph"}']),
    op('fetchAsset', uri=st.text(max_size=5), requestId=numbers),
    st.tuples(numbers, cdr).map(lambda pair: struct.pack('<BI', 1, pair[0]) + pair[1]),
    st.tuples(numbers, numbers, cdr).map(lambda row: struct.pack('<BIII', 2, row[0], row[1], 3) + b'cdr' + row[2]),
    st.tuples(numbers, fields).map(lambda pair: struct.pack('<BI', 1, pair[0]) + json.dumps(pair[1]).encode()),
    st.binary(max_size=30),
)


@given(st.lists(words | st.just('turn'), max_size=30))
def test_any_words_in_any_order_do_no_harm(said: list[str | bytes]) -> None:
    with Session() as session, streams_of_programs():
        session.host.start(ProcessSpec(argv=('ros2', 'run', 'turtlesim', 'turtlesim_node'), name='sim'))
        session.run(0.1)
        machine = Machine(session)
        bad, good = (Spoken(Conversation(LiveFeed(machine, number))) for number in (1, 2))
        good.turn()
        good.subscribe('/turtle1/pose')
        for message in said:
            if message == 'turn':
                session.run(0.05)
                bad.turn()
            else:
                try:
                    bad.conversation.take(message)
                except TooMuch:
                    break
        session.run(0.2)
        bad.turn()
        bad.conversation.close()
        good.turn()
        assert len(good.data()) >= 12 and good.statuses() == []
        assert '_foxglove_1' not in [node.name for node in session.graph.nodes]
