import pytest

from edulaunch.errors import InterfaceError
from edulaunch.interfaces.sections import sections_of


def test_comments_and_blank_lines_are_left_out_but_counted():
    [[line]] = sections_of('# note\n\n  int8 a # why\n', 'f', 'msg', 1)
    assert (line.number, line.text) == (3, 'int8 a')


@pytest.mark.parametrize(
    ('text', 'kind', 'wanted', 'message'),
    [
        (
            'int8 a',
            'srv',
            2,
            ("f.srv:1: expected 1 more line with '---'\n  help: a .srv file is: request --- response; a part may be empty"),
        ),
        (
            '',
            'action',
            3,
            (
                "f.action:1: expected 2 more lines with '---'\n"
                '  help: a .action file is: goal --- result --- feedback; a part may be empty'
            ),
        ),
        ('---', 'msg', 1, "f.msg:1: a .msg file has no line with '---'; this is one too many"),
        ('---\n---', 'srv', 2, "f.srv:2: a .srv file has 1 line with '---'; this is one too many"),
        ('----', 'srv', 2, "f.srv:1: expected '---' alone on its line, not '----'"),
    ],
)
def test_the_number_of_parts_must_fit_the_kind(text, kind, wanted, message):
    with pytest.raises(InterfaceError) as caught:
        sections_of(text, f'f.{kind}', kind, wanted)
    assert str(caught.value) == message
