"""What is said of a thing that a recording does not have."""

from __future__ import annotations

import pytest

from edulaunch.engine.recording.absent import NodeParameters, NoMessages, NotRecorded, RecordedFrames, not_recorded


@pytest.mark.parametrize(
    ('among', 'text', 'help'),
    [
        (['speed', 'size', 'speed'], "no x 'sped' in this recording; there are: speed, size", "did you mean 'speed'?"),
        (['other'], "no x 'sped' in this recording; there are: other", None),
        ([], "no x 'sped' in this recording; there are: none", None),
    ],
)
def test_an_error_lists_each_name_once_and_the_nearest_one(among: list[str], text: str, help: str | None) -> None:
    error = not_recorded("no x 'sped'", 'sped', among)
    assert (str(error.args[0]), error.help) == (text, help)


@pytest.mark.parametrize(
    ('ended_s', 'help'), [(None, "did you mean 'speed'?"), (0.0, '/a ended at 0.00 s: '), (2.5, '/a ended at 2.50 s: ')]
)
def test_a_parameter_that_is_not_there_names_the_end_of_the_node(ended_s: float | None, help: str) -> None:
    parameters = NodeParameters('/a', ended_s)
    parameters['speed'] = 1
    assert parameters['speed'] == 1
    with pytest.raises(NotRecorded, match="no parameter 'sped' of /a") as told:
        parameters['sped']
    assert told.value.help is not None and told.value.help.startswith(help)


def test_messages_that_never_came_are_an_empty_list_until_one_is_asked_for() -> None:
    messages = NoMessages('/chater', ['/chatter', '/rosout'])
    assert (len(messages), list(messages), messages[1:], messages == []) == (0, [], [], True)
    with pytest.raises(NotRecorded, match="no topic '/chater'") as told:
        messages[0]
    assert told.value.help == "did you mean '/chatter'?"


def test_a_frame_that_was_never_broadcast_is_told_with_those_that_were() -> None:
    frames = RecordedFrames()
    with pytest.raises(NotRecorded, match="no tf frame 'world' in this recording; there are: none"):
        frames['world']
