"""Which endpoints of a run could not talk to each other."""

from __future__ import annotations

import pytest

from edulaunch.engine.recording.mismatches import Mismatch, mismatches
from edulaunch.engine.recording.records import NodeRecord, Note

TEXT, NUMBER = 'std_msgs/msg/String', 'std_msgs/msg/Int32'


def node(name: str, publishes: tuple[str, ...] = (), hears: tuple[str, ...] = ()) -> NodeRecord:
    ends = ([('/chatter', kind) for kind in kinds] for kinds in (publishes, hears))
    return NodeRecord(name, name[1:], 0.0, None, *ends, [], [])


def note(why: str, kind: str = 'incompatible', subscriber: str = '/ear') -> Note:
    return Note(1.0, None, kind, f'/chatter: /mouth ({TEXT}) and {subscriber} ({NUMBER}) cannot talk because of {why}')


def found(given: Note, *hears: str) -> list[Mismatch]:
    return list(mismatches([node('/mouth', (TEXT,)), node('/ear', hears=hears)], [given]))


@pytest.mark.parametrize('why', ['TYPE', 'RELIABILITY', 'DURABILITY'])
def test_a_note_names_topic_reason_and_both_nodes(why: str) -> None:
    given = note(why)
    assert found(given, NUMBER) == [Mismatch(given, '/chatter', why, '/mouth', '/ear')]


def test_a_node_that_takes_several_types_hears_one_of_them() -> None:
    assert found(note('TYPE'), NUMBER, TEXT) == []
    assert len(found(note('RELIABILITY'), NUMBER, TEXT)) == 1, 'a policy keeps them apart all the same'


def test_other_notes_and_nodes_that_nobody_knows_are_left_out() -> None:
    assert found(note('TYPE', kind='real machine'), NUMBER) == []
    assert found(note('TYPE', subscriber='/nobody'), NUMBER) == []
    assert found(Note(1.0, None, 'incompatible', 'something else'), NUMBER) == []
