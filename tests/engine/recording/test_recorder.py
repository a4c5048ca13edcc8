"""What a recorder collects of a run, row by row, and what it forgets."""

from __future__ import annotations

from typing import Any

from edulaunch.engine.graph.qos import QoS

from .conftest import Stage

S = 1_000_000_000


class Text:
    TYPE = 'test_msgs/msg/Text'


def test_facts_are_counted_by_key_withdrawn_and_forgotten_with_their_program() -> None:
    stage = Stage()
    short, long = stage.process('short', 1.0), stage.process('long', 50.0)
    stage.at(0.5, lambda: short.fact('odd', 'a', {'file': 'x.py', 'line': 1}))
    stage.at(0.75, lambda: short.fact('odd', 'a', {'file': 'x.py', 'line': 9}))
    stage.at(0.75, lambda: long.fact('odd', 'a', {}))
    stage.at(0.8, lambda: long.fact('over', 'b', {}))
    stage.at(0.9, lambda: long.fact_over('over', 'b'))
    stage.sim.run(stage.sim.start_ns + 10 * S)
    first = [S // 2, 'short', 'odd', {'file': 'x.py', 'line': 9}, 2, 3 * S // 4]
    second = [3 * S // 4, 'long', 'odd', {}, 1, 3 * S // 4]
    assert stage.recorder.facts_now() == [first, second]
    assert [(pid, row[1]) for pid, row in stage.recorder.facts_of()] == [(1001, 'short'), (1002, 'long')]
    stage.recorder.forget_before(stage.sim.start_ns + S // 2, kept=0)
    assert stage.recorder.facts_now() == [first, second], 'the last time was later'
    stage.recorder.forget_before(stage.sim.start_ns + 9 * S, kept=0)
    assert stage.recorder.facts_now() == [second], 'the program still runs'
    stage.finish(11)


def test_rows_keep_their_numbers_when_earlier_ones_are_forgotten() -> None:
    stage = Stage()
    for name in ('a', 'b', 'c'):
        stage.process(name, {'a': 1.0, 'b': 50.0, 'c': 3.0}[name])
    for second in (1, 2, 3):
        stage.at(second, lambda: stage.host.processes[0].write('stdout', f'{stage.sim.elapsed_s}\n'))
    stage.sim.run(stage.sim.start_ns + 10 * S)
    assert [row[3] for row in stage.recorder.output_lines] == ['1.0\n', '2.0\n', '3.0\n']
    stage.recorder.forget_before(stage.sim.start_ns + 2 * S, kept=0)
    assert [row['name'] for row in stage.recorder.processes] == ['b', 'c']
    assert (list(stage.recorder.numbers('processes')), list(stage.recorder.numbers('output_lines'))) == ([1, 2], [2])
    assert [row[3] for row in stage.recorder.output_lines] == ['3.0\n']
    assert stage.recorder.forgotten['processes'] == 1 and stage.recorder.forgotten['output_lines'] == 2
    stage.finish(11)


def test_messages_are_forgotten_by_time_except_the_last_ones_of_each_topic() -> None:
    stage = Stage()
    node = stage.graph.add_node(stage.process('p', 50.0), 'n', '/')
    ends = {name: stage.graph.create_publisher(node, name, Text, QoS()) for name in ('/often', '/seldom')}
    for second in range(1, 9):
        stage.at(second, lambda: ends['/often'].publish((stage.sim.elapsed_s,)))
    stage.at(1, lambda: ends['/seldom'].publish(('once',)))
    stage.sim.run(stage.sim.start_ns + 10 * S)
    stage.recorder.forget_before(stage.sim.start_ns + 6 * S, kept=1)
    columns: dict[Any, list[Any]] = {topic: flat[2::3] for (topic, _), flat in stage.recorder.columns.items()}
    assert {topic: [wire[0] for wire in wires] for topic, wires in columns.items()} == {'/often': [7.0, 8.0], '/seldom': ['once']}
    stage.recorder.forget_before(stage.sim.start_ns + 6 * S, kept=5)
    assert len(columns['/often']) == 2, 'what is forgotten does not come back'
    stage.finish(11)


def test_nothing_is_recorded_after_the_end() -> None:
    stage = Stage()
    process = stage.process('p', 50.0)
    stage.sim.run(stage.sim.start_ns + S)
    stage.recorder.stop()
    stage.sim.run(stage.sim.start_ns + 2 * S)
    for action in (
        lambda: process.write('stdout', 'x\n'),
        lambda: process.note('stopped', 'x'),
        lambda: process.fact('odd', 1, {}),
    ):
        action()
    process.log(20, 'p', 'x')
    content = stage.recorder.content()
    assert [content[name] for name in ('output', 'notes', 'facts', 'logs', 'duration_ns')] == [[], [], [], [], S]
    stage.host.close()
