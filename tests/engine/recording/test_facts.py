"""Odd facts: noted by programs, counted, taken back, looked up at a node when it leaves; and their place in the file."""

from __future__ import annotations

import pytest

from edulaunch.engine.recording import Recording
from edulaunch.errors import RecordingError
from tests.engine.recording.conftest import Stage, turtle_run


def test_a_fact_is_counted_under_its_key_and_keeps_its_first_time_and_latest_data(stage: Stage) -> None:
    process = stage.process('odd-1', 10)
    for second in (1, 2, 3):
        stage.at(second, lambda second=second: process.fact('late', 'key', {'by': second}))
    stage.at(2.5, lambda: process.fact('late', 'other', {'by': 9}))
    facts = stage.finish(5).facts
    assert [(fact.time_s, fact.process, fact.data, fact.times, fact.last_s) for fact in facts] == [
        (1.0, 'odd-1', {'by': 3}, 3, 3.0),
        (2.5, 'odd-1', {'by': 9}, 1, 2.5),
    ]


def test_a_fact_that_came_right_never_was(stage: Stage) -> None:
    process = stage.process('odd-1', 10)
    stage.at(1, lambda: process.fact('late', 'key', {}))
    stage.at(2, lambda: process.fact_over('late', 'key'))
    assert stage.finish(5).facts == []


def test_a_node_is_looked_at_when_it_leaves_or_at_the_end(stage: Stage) -> None:
    process, early = stage.process('stays-1', 10), stage.process('leaves-2', 1)
    stays, leaves = stage.graph.add_node(process, 'stays', '/'), stage.graph.add_node(early, 'leaves', '/')
    for node in (stays, leaves):
        stage.recorder.watch(node, lambda node=node: [('seen', {'node': node.name, 'at': stage.sim.elapsed_s})])
    facts = stage.finish(3).facts
    assert [(fact.time_s, fact.data) for fact in facts] == [
        (1.0, {'node': 'leaves', 'at': 1.0}),
        (3.0, {'node': 'stays', 'at': 3.0}),
    ]


def test_a_run_without_odd_facts_has_no_such_part(recording: Recording) -> None:
    assert recording.facts == []
    assert b'"facts"' not in recording.to_bytes()


def test_facts_survive_the_file_and_count_in_the_digest_without_folders(stage: Stage) -> None:
    process = stage.process('odd-1', 10)
    stage.recorder.roots = [['/home/me', '@me']]
    stage.at(1, lambda: process.fact('late', 'key', {'file': '/home/me/a.py', 'line': 3, 'names': ['x']}))
    first = stage.finish(2)
    again = Recording.from_bytes(first.to_bytes())
    assert again.facts == first.facts and again.facts[0].data == {'file': '/home/me/a.py', 'line': 3, 'names': ['x']}
    elsewhere = Recording.from_bytes(first.to_bytes().replace(b'/home/me', b'/srv/you'))
    assert elsewhere.digest() == first.digest()
    without = first.to_bytes().splitlines()
    assert Recording.from_bytes(b'\n'.join(line for line in without if b'"facts"' not in line)).digest() != first.digest()


@pytest.mark.parametrize('part', [b'{"descriptors":3}', b'{"descriptors":[[1,"/n","p","",false,[0,1]]]}'])
def test_damaged_descriptors_are_refused(part: bytes) -> None:
    with pytest.raises(RecordingError, match="the part 'descriptors'"):
        Recording.from_bytes(turtle_run().to_bytes() + part + b'\n')


@pytest.mark.parametrize('part', [b'{"facts":3}', b'{"facts":[[1,"p","kind",{},1]]}', b'{"facts":[[1,"p","kind",[],1,2]]}'])
def test_damaged_facts_are_refused(part: bytes) -> None:
    with pytest.raises(RecordingError, match="the part 'facts'"):
        Recording.from_bytes(turtle_run().to_bytes() + part + b'\n')
