"""edulaunch.engine.graph.names."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.graph import names
from edulaunch.engine.graph.names import RemapRule

token = st.from_regex(r'[A-Za-z_][A-Za-z0-9_]{0,8}', fullmatch=True)
absolute = st.lists(token, min_size=1, max_size=3).map(lambda parts: '/' + '/'.join(parts))


@pytest.mark.parametrize(
    ('name', 'problem'),
    [
        ('', ('node name must not be empty', 0)),
        ('a-b', ("node name must not contain characters other than alphanumerics or '_'", 1)),
        ('1a', ('node name must not start with a number', 0)),
        ('n' * 256, ("node name length should not exceed '255'", 254)),
        ('turtle1', None),
    ],
)
def test_node_names(name: str, problem: names.Problem | None) -> None:
    assert names.node_name_problem(name) == problem


@pytest.mark.parametrize(
    ('namespace', 'problem'),
    [
        ('/', None),
        ('/a/b', None),
        ('/a/', ("namespace must not end with a '/', unless only a '/'", 2)),
        ('/a b', ("namespace must not contain characters other than alphanumerics, '_', or '/'", 2)),
        ('/a//b', ("namespace must not contain repeated '/'", 3)),
        ('/a/1b', ('namespace must not have a token that starts with a number', 3)),
    ],
)
def test_namespaces(namespace: str, problem: names.Problem | None) -> None:
    assert names.namespace_problem(namespace) == problem


@pytest.mark.parametrize(
    ('name', 'problem'),
    [
        ('chatter', None),
        ('/a/b', None),
        ('~', None),
        ('~/x', None),
        ('{node}/x', None),
        ('a//b', None),
        ('~a', None),
        ('', ('topic name must not be empty string', 0)),
        ('a/', ('topic name must not end with a forward slash', 1)),
        ('a b', ("topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'", 1)),
        ('1a', ('topic name token must not start with a number', 0)),
        ('a/1b', ('topic name token must not start with a number', 2)),
        ('a~', ("topic name must not have tilde '~' unless it is the first character", 1)),
        ('{{node}}', ("substitution name must not contain characters other than alphanumerics or '_'", 1)),
        ('a{b', ("topic name must not have unmatched (unbalanced) curly braces '{}'", 1)),
    ],
)
def test_topic_names_as_written(name: str, problem: names.Problem | None) -> None:
    assert names.topic_name_problem(name) == problem


def test_repeated_slashes_are_found_in_the_expanded_name_only() -> None:
    assert names.full_topic_name_problem('//a') == ("topic name must not contain repeated '/'", 1)
    assert names.full_topic_name_problem('/a//b') == ("topic name must not contain repeated '/'", 3)


def test_a_refused_name_is_shown_with_a_caret_under_the_place() -> None:
    problem = names.topic_name_problem('turtle 1')
    assert problem is not None
    assert names.caret_text('topic name', 'turtle 1', problem) == (
        "Invalid topic name: topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}':\n"
        "  'turtle 1'\n"
        '         ^'
    )


@pytest.mark.parametrize(
    ('name', 'expanded'),
    [
        ('/abs', '/abs'),
        ('rel', '/ns/rel'),
        ('~', '/ns/n'),
        ('~/x', '/ns/n/x'),
        ('{node}/x', '/ns/n/x'),
        ('/{ns}/x', '//ns/x'),
        ('{namespace}/x', '/ns/x'),
        ('~a', '/ns/na'),
    ],
)
def test_expansion(name: str, expanded: str) -> None:
    assert names.expand_name(name, 'n', '/ns') == expanded


def test_the_root_namespace_adds_no_second_slash() -> None:
    assert [names.expand_name(name, 'n', '/') for name in ('x', '~/x')] == ['/x', '/n/x']


def test_an_unknown_substitution_is_refused() -> None:
    with pytest.raises(ValueError, match='unknown substitution: {pkg}'):
        names.expand_name('{pkg}/x', 'n', '/')
    assert names.UnknownSubstitution.__name__ == 'ValueError'


@given(token, token, absolute)
def test_expanded_names_obey_the_rules(name: str, node: str, namespace: str) -> None:
    for written in (name, f'~/{name}', f'{{node}}/{name}'):
        assert names.full_topic_name_problem(names.expand_name(written, node, namespace)) is None


@given(absolute, token, absolute)
def test_expanding_twice_is_expanding_once(name: str, node: str, namespace: str) -> None:
    assert names.expand_name(name, node, namespace) == name


def test_rules_do_not_chain_and_the_first_wins() -> None:
    rules = [RemapRule('any', None, 'a', 'b'), RemapRule('any', None, 'b', 'c'), RemapRule('any', None, 'a', 'd')]
    assert [names.remapped_name(rules, 'topic', name, 'n', '/') for name in ('/a', '/b', '/d')] == ['/b', '/c', '/d']


def test_both_sides_of_a_rule_are_expanded_in_the_node() -> None:
    rules = [RemapRule('any', None, 'input/pose', '~/pose')]
    assert names.remapped_name(rules, 'topic', '/ns/input/pose', 'mimic', '/ns') == '/ns/mimic/pose'


def test_a_relative_rule_does_not_match_another_namespace() -> None:
    assert names.remapped_name([RemapRule('any', None, 'a', 'b')], 'topic', '/a', 'n', '/ns') == '/a'


def test_schemes_and_node_names_limit_a_rule() -> None:
    rules = [RemapRule('topic', None, 'a', 'b'), RemapRule('any', 'other', 'c', 'd')]
    assert names.remapped_name(rules, 'service', '/a', 'n', '/') == '/a'
    assert names.remapped_name(rules, 'topic', '/c', 'n', '/') == '/c'
    assert names.remapped_name(rules, 'topic', '/c', 'other', '/') == '/d'


def test_node_and_namespace_rules() -> None:
    rules = [RemapRule('node', 'old', '__node', 'new'), RemapRule('namespace', 'new', '__ns', '/deep')]
    name = names.remapped_node_name(rules, 'old')
    assert (name, names.remapped_namespace(rules, name, '/')) == ('new', '/deep')


def test_hidden_names_have_a_token_that_begins_with_an_underscore() -> None:
    assert [names.is_hidden(name) for name in ('/a/_action/status', '/a_b', '_x')] == [True, False, True]


@given(st.text('aB9_/~{} é', max_size=8))
def test_the_quick_look_passes_only_what_the_slow_one_passes(name: str) -> None:
    """The rules written out once more, as slowly as they can be."""
    tokens = name.split('/')
    good = all(token and token[0] not in '0123456789' and set(token) <= set('aB9_') for token in tokens)
    assert not good or names.topic_name_problem(name) is None
    assert (names.full_topic_name_problem('/' + name) is None) == good
    assert (names.node_name_problem(name) is None) == (good and len(tokens) == 1)


@given(st.text('ab1/_~{} é', max_size=8), st.one_of(st.just('/'), absolute))
def test_the_short_way_for_plain_names_gives_what_the_long_way_gives(name: str, namespace: str) -> None:
    quick = names.plain_name(name, namespace)
    if quick is not None:
        assert names.topic_name_problem(name) is None
        assert quick == names.expand_name(name, 'node', namespace)
        assert names.full_topic_name_problem(quick) is None


@pytest.mark.parametrize(('length', 'plain'), [(245, True), (247, False)])
def test_a_plain_name_must_fit(length: int, plain: bool) -> None:
    assert (names.plain_name('t' * length, '/') is not None) is plain
    assert (names.full_topic_name_problem('/' + 't' * length) is None) is plain
