"""How lines are read, and what their words become."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.runtime.shell.grammar import Expansion, Line, Piece, commands, known_words, parsed, stands_for_more


def read(text: str) -> Line:
    line = parsed(text)
    assert line is not None, text
    return line


def plain(word: tuple[Piece, ...]) -> str:
    return ''.join(piece.text for piece in word)


@pytest.mark.parametrize(
    ('text', 'jobs'),
    [
        ('a; b & c', [('a', False), ('b ', True), ('c', False)]),
        ('a\nb\n\n c ', [('a', False), ('b', False), ('c ', False)]),
        ('a && b || c | d', [('a && b || c | d', False)]),
        ('a # one\nb # two', [('a # one', False), ('b # two', False)]),
        ('a \\\n b', [('a \\\n b', False)]),
        ('# first\na', [('a', False)]),
    ],
)
def test_jobs_know_their_text_and_whether_they_run_beside(text: str, jobs: list[tuple[str, bool]]) -> None:
    assert [(job.text, job.is_beside) for job in read(text)] == jobs


def test_pipelines_have_the_operator_before_them() -> None:
    (job,) = read('a b | c && d || e|f')
    assert [(joint, [[plain(word) for word in command.words] for command in pipeline]) for joint, pipeline in job.parts] == [
        ('', [['a', 'b'], ['c']]),
        ('&&', [['d']]),
        ('||', [['e'], ['f']]),
    ]


@pytest.mark.parametrize(
    ('text', 'found'),
    [
        ('a > b', [('stdout', 'w', 'b')]),
        ('a>>b', [('stdout', 'a', 'b')]),
        ('a 1> b', [('stdout', 'w', 'b')]),
        ('a 2>> b', [('stderr', 'a', 'b')]),
        ('a &> b', [('both', 'w', 'b')]),
        ('a < b', [('stdin', 'r', 'b')]),
        ('a > b 2>&1', [('stdout', 'w', 'b'), ('stderr', 'w', None)]),
    ],
)
def test_redirections(text: str, found: list[tuple[str, str, str | None]]) -> None:
    (command,) = commands(read(text))
    assert [(one.stream, one.mode, None if one.place is None else plain(one.place)) for one in command.redirections] == found
    assert [plain(word) for word in command.words] == ['a']


@pytest.mark.parametrize(
    'text',
    [
        'a 1>&1',
        'a 2>>&1',
        'a >&1',
        'a < ',
        'a > ;',
        'a |& b',
        'if',
        '{ a; }',
        '! a',
        'a )',
        '$((1))',
        '${a',
        '`a',
        '``',
        'a "b\\',
    ],
)
def test_what_is_not_in_the_grammar(text: str) -> None:
    assert parsed(text) is None


@pytest.mark.parametrize(('text', 'words'), [("'if' a", ['if', 'a']), ('a if', ['a', 'if']), ('a=1 b=2 c=3', ['c=3'])])
def test_reserved_words_and_settings_are_so_only_at_the_beginning(text: str, words: list[str]) -> None:
    text = text.replace(' c=3', ' x c=3') if text.startswith('a=') else text
    (command,) = commands(read(text))
    assert [plain(word) for word in command.words] == (['x', *words] if command.settings else words)
    assert [(name, plain(word)) for name, word in command.settings] == ([('a', '1'), ('b', '2')] if command.settings else [])


def test_commands_inside_of_others_are_found_in_their_order() -> None:
    line = read('a $(b `c`) | d; e x"$(f)"')
    assert [plain(command.words[0]) for command in commands(line)] == ['a', 'b', 'c', 'd', 'e', 'f']


@pytest.mark.parametrize(
    ('text', 'more'), [('a b', False), ("a '$b'", False), ('a $b', True), ('a "x$(b)"', True), ('if', False)]
)
def test_whether_words_are_known_only_when_the_line_runs(text: str, more: bool) -> None:
    assert stands_for_more(text) is more


VARIABLES = {'A': 'one', 'B': 'two words', 'EMPTY': '', 'HOME': '/home/me'}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ('b.txt', 'a.txt', 'c[1].md', '*'):
        (tmp_path / name).touch()
    return tmp_path


@pytest.mark.parametrize(
    ('text', 'words'),
    [
        ('a$A ${A}b $B', ['aone', 'oneb', 'two', 'words']),
        ('x$B"$B"', ['xtwo', 'wordstwo words']),
        ('$NIX "$NIX" $EMPTY', ['']),
        ('${NIX:-d} ${EMPTY:-e} ${A:-f}', ['d', 'e', 'one']),
        ('$0 $1 $2 $9 ${9:-nine}', ['sh', 'x', 'y', 'z', 'nine']),
        ('"$@"', ['x', 'y z']),
        ('a"$@"b', ['ax', 'y zb']),
        ('$@ "$*" $*', ['x', 'y', 'z', 'x y z', 'x', 'y', 'z']),
        ('$(a b) "$(a b)"', ['a', 'b', 'a b']),
        ('~ ~/x "~" a~ ~a', ['/home/me', '/home/me/x', '~', 'a~', '~a']),
        ('*.txt', ['a.txt', 'b.txt']),
        ('[ab].txt ?.txt', ['a.txt', 'b.txt', 'a.txt', 'b.txt']),
        ('"*".txt *.nix \\*', ['*.txt', '*.nix', '*']),
        ('c[1].md "c[1]"*', ['c[1].md', 'c[1].md']),
        ("'a b'c", ['a bc']),
        ('"a\\"b\\c"', ['a"b\\c']),
    ],
)
def test_words_become_what_a_shell_makes_of_them(folder: Path, text: str, words: list[str]) -> None:
    def written(line: Line) -> str:
        return ' '.join(plain(word) for command in commands(line) for word in command.words) + '\n\n'

    expansion = Expansion(VARIABLES, ['sh', 'x', 'y z'], str(folder), written)
    (command,) = (one for one in read(f'c {text}')[0].parts[0][1])
    assert expansion.words(command.words) == ['c', *words]


def test_patterns_fit_files_at_absolute_places_too(folder: Path) -> None:
    expansion = Expansion({}, [], '/', lambda line: '')
    (command,) = commands(read(f'c {folder}/*.txt'))
    assert expansion.words(command.words)[1:] == [f'{folder}/a.txt', f'{folder}/b.txt']


@pytest.mark.parametrize(('text', 'value'), [('$B', 'two words'), ('~/"$A"*', '/home/me/one*'), ('$*', 'x y z'), ('$(a)', 'out')])
def test_a_file_or_value_stays_one_word(text: str, value: str) -> None:
    expansion = Expansion(VARIABLES, ['sh', 'x', 'y z'], None, lambda line: 'out\n')
    (command, *_) = commands(read(f'c {text}'))
    assert expansion.one(command.words[1]) == value


@pytest.mark.parametrize(
    ('text', 'words'),
    [('ros2 run "$@" x', ['ros2', 'run', 'a', 'b c', 'x']), ('run $X y', ['run', '$', 'y']), ('run $(x) $1', ['run', '$', 'a'])],
)
def test_words_that_are_known_before_a_line_runs(text: str, words: list[str]) -> None:
    (command, *_) = commands(read(text))
    assert known_words(command, ['sh', 'a', 'b c']) == words


def test_an_empty_text_is_a_word() -> None:
    assert [plain(word) for word in next(commands(read('a ""'))).words] == ['a', '']
