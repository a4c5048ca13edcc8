"""The grammar of `$(...)`."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from launch.frontend.parse_substitution import (
    MAX_DEPTH,
    Call,
    SubstitutionSyntaxError,
    UnexpectedCharacters,
    UnexpectedEOF,
    parse_template,
)

from tests.house import EXAMPLES


@pytest.mark.parametrize(
    ('text', 'pieces'),
    [
        ('', ()),
        ('plain text', ('plain text',)),
        ('$(var x)', (Call('var', (('x',),)),)),
        ('a$(var x)b', ('a', Call('var', (('x',),)), 'b')),
        ('$(dirname)/x', (Call('dirname', ()), '/x')),
        ('$(var a b)', (Call('var', (('a',), ('b',))),)),
        ('$(var a$(env B)c)', (Call('var', (('a', Call('env', (('B',),)), 'c'),)),)),
        ("$(var a 'b c')", (Call('var', (('a',), ('b c',))),)),
        ('$(var a "")', (Call('var', (('a',), ())),)),
        ("""$(eval "'$(var s)' == ")""", (Call('eval', (("'", Call('var', (('s',),)), "' == "),)),)),
        (r"$(eval 'it\'s')", (Call('eval', (("it's",),)),)),
        (r'$(var a\ b)', (Call('var', (('a b',),)),)),
        ('$var $ (x) 5$', ('$var $ (x) 5$',)),
        (r'\$(var x)', ('$(var x)',)),
        (r'a\\b\c', (r'a\bc',)),
        ('$(a-b_1 x)', (Call('a-b_1', (('x',),)),)),
        ('two\nlines', ('two\nlines',)),
    ],
)
def test_text_is_split_into_literals_and_calls(text, pieces):
    assert parse_template(text) == pieces


@pytest.mark.parametrize(
    ('text', 'column'),
    [
        ('$()', 3),
        ('$( var)', 3),
        ('$(1x)', 3),
        ('$(var  x)', 7),
        ('$(var x )', 9),
        ('$(var\tx)', 6),
        ("$(var 'a'b)", 10),
        ("$(var a'b')", 8),
        ('$(var (x))', 7),
        ('$(var $x)', 7),
        ('a\\', 2),
    ],
)
def test_a_character_out_of_place_is_pointed_at(text, column):
    with pytest.raises(UnexpectedCharacters) as caught:
        parse_template(text)
    assert (caught.value.line, caught.value.column) == (1, column)
    assert f'at line 1 col {column}\n\n{text}\n{" " * (column - 1)}^\n' in str(caught.value)


@pytest.mark.parametrize('text', ['$(', '$(var', '$(var ', '$(var x', "$(var 'x", '$(var $(var x)'])
def test_an_end_inside_is_unexpected(text):
    with pytest.raises(UnexpectedEOF, match=r'^Unexpected end-of-input\. Expected one of: '):
        parse_template(text)


def test_the_place_counts_lines():
    with pytest.raises(UnexpectedCharacters, match='at line 2 col 4\n\nb\\$\\(\\)\n   \\^\n'):
        parse_template('a\nb$()')


def test_nesting_has_a_limit():
    deepest = '$(var ' * MAX_DEPTH + 'x' + ')' * MAX_DEPTH
    assert isinstance(parse_template(deepest)[0], Call)
    with pytest.raises(SubstitutionSyntaxError, match='more than 50 substitutions'):
        parse_template(f'$(var {deepest})')


def test_long_texts_take_linear_time():
    assert parse_template('$' * 100_000) == ('$' * 100_000,)
    assert len(parse_template('$(var x)' * 10_000)) == 10_000


@settings(max_examples=3 * EXAMPLES)
@given(st.text())
def test_every_text_can_be_written_by_escaping(text):
    written = text.replace('\\', '\\\\').replace('$', '\\$')
    assert ''.join(parse_template(written)) == text


@settings(max_examples=3 * EXAMPLES)
@given(st.text(alphabet=st.sampled_from('$()\'"\\ varx\n')))
def test_no_text_breaks_the_parser(text):
    try:
        parse_template(text)
    except SubstitutionSyntaxError as error:
        assert 'Unexpected end-of-input' in str(error) or 'No terminal matches' in str(error)


def test_inside_quotes_the_arguments_of_a_call_are_bare_and_the_other_quote_is_a_character():
    assert parse_template('$(env "a_$(test \'b\')")') == (Call('env', (('a_', Call('test', (("'b'",),))),)),)
    assert parse_template('$(env \'a_$(test "b" c)\')') == (Call('env', (('a_', Call('test', (('"b"',), ('c',)))),)),)
    assert parse_template('$(env "a_$(test \\"b\\")" \'$(env D)_q\')')[0].arguments[0] == ('a_', Call('test', (('"b"',),)))
    with pytest.raises(UnexpectedCharacters):
        parse_template('$(env "$(test "b")")')
