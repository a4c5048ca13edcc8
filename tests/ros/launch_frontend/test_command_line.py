"""Splitting command lines."""

import pytest
from launch.actions import ExecuteProcess
from launch.frontend import Parser
from launch.frontend.elements import words_of


def described(text):
    return [[piece.describe() for piece in word] for word in words_of(text, Parser())]


@pytest.mark.parametrize(
    ('text', 'words'),
    [
        ('ls -l', [["'ls'"], ["'-l'"]]),
        ('', [[]]),
        ('  $(var a)', [[], ["LaunchConfig('a')"]]),
        ('  ls  ', [["'ls'"]]),
        ('ls "a b" \'c d\'', [["'ls'"], ["'a b'"], ["'c d'"]]),
        ('$(var a) $(var b)', [["LaunchConfig('a')"], ["LaunchConfig('b')"]]),
        ('$(var a)$(var b)', [["LaunchConfig('a')", "LaunchConfig('b')"]]),
        ('-x$(var a)/y z', [["'-x'", "LaunchConfig('a')", "'/y'"], ["'z'"]]),
        ('a $(var b) c', [["'a'"], ["LaunchConfig('b')"], ["'c'"]]),
        ('a b$(var c)', [["'a'"], ["'b'", "LaunchConfig('c')"]]),
        ('ls -l $(var s)/x$(var i) "a b"', [["'ls'"], ["'-l'"], ["LaunchConfig('s')", "'/x'", "LaunchConfig('i')"], ["'a b'"]]),
        ('a ""', [["'a'"], ["''"]]),
    ],
)
def test_literal_pieces_are_split_and_substitutions_are_not(text, words):
    assert described(text) == words


def test_a_quote_must_be_closed_before_a_substitution():
    with pytest.raises(ValueError, match='No closing quotation'):
        words_of('"a $(var b)"', Parser())


def test_extensions_split_command_lines_by_the_name_of_the_original():
    words = ExecuteProcess._parse_cmdline('$(var a)$(var b) c', Parser())
    assert [[part.describe() for part in word] for word in words] == [["LaunchConfig('a')", "LaunchConfig('b')"], ["'c'"]]
