"""From attribute texts to substitutions."""

import pytest
from launch.frontend.expose import substitution_parse_methods
from launch.frontend.parse_substitution import (
    SubstitutionSyntaxError,
    VisitError,
    parse_if_substitutions,
    parse_substitution,
    replace_escaped_characters,
)
from launch.substitutions import TextSubstitution

from edulaunch.engine.facts import facts_of


def described(text):
    return [substitution.describe() for substitution in parse_substitution(text)]


def visit_error(text):
    with pytest.raises(VisitError) as caught:
        parse_substitution(text)
    return caught.value


@pytest.mark.parametrize(
    ('text', 'descriptions'),
    [
        ('', ["''"]),
        ('plain', ["'plain'"]),
        ('a $(var b c) d', ["'a '", "LaunchConfig('b')", "' d'"]),
        ('$(env HOME)', ["EnvVar('HOME')"]),
        ('$(dirname)/x.yaml', ['ThisLaunchFileDir()', "'/x.yaml'"]),
        ('$(filename)', ['ThisLaunchFile()']),
        ("$(eval '1 + 2' 'sys, os')", ["PythonExpr('1 + 2', ['sys', 'os'])"]),
        ("$(command 'ls -l')", ["Command('ls -l')"]),
        ('$(find-exec ls)', ["FindExec('ls')"]),
        ('$(log_dir)', ['LaunchLogDir()']),
        ('$(anon x)', ["AnonName('x')"]),
        ('$(file-content f)', ["FileContent('f')"]),
    ],
)
def test_each_keyword_makes_its_class(text, descriptions):
    assert described(text) == descriptions


@pytest.mark.parametrize(
    ('text', 'name'),
    [
        ('$(not true)', 'NotSubstitution'),
        ('$(and 1 0)', 'AndSubstitution'),
        ('$(or 1 0)', 'OrSubstitution'),
        ('$(equals a b)', 'EqualsSubstitution'),
        ('$(not-equals a b)', 'NotEqualsSubstitution'),
        ("$(if true 'a' 'b')", 'IfElseSubstitution'),
        ('$(find-pkg-share p)', 'FindPackageShare'),
        ('$(find-pkg-prefix p)', 'FindPackagePrefix'),
        ('$(exec-in-pkg e p)', 'ExecutableInPackage'),
        ('$(param p)', 'Parameter'),
        ('$(launch_log_dir)', 'LaunchLogDir'),
    ],
)
def test_keywords_without_a_description_too(text, name):
    assert [type(substitution).__name__ for substitution in parse_substitution(text)] == [name]


@pytest.mark.parametrize(
    ('text', 'message'),
    [
        ('$(var)', 'var substitution expects 1 or 2 arguments'),
        ('$(var a b c)', 'var substitution expects 1 or 2 arguments'),
        ('$(eval)', 'eval substitution expects 1 or 2 arguments'),
        ('$(not a b)', 'not substitution expects 1 argument'),
        ('$(or a)', 'and substitution expects 2 arguments'),
        ('$(unknown x)', 'Unknown substitution: unknown'),
    ],
)
def test_a_call_that_cannot_be_made_is_a_visit_error(text, message):
    assert str(visit_error(text)) == f'Error trying to process rule "substitution":\n\n{message}'


def test_the_error_behind_a_visit_error_keeps_its_type():
    assert isinstance(visit_error('$(var)').orig_exc, TypeError)
    assert isinstance(visit_error('$(find-exec)').__cause__, AttributeError)
    assert isinstance(visit_error('$(unknown)').orig_exc, RuntimeError)


def test_a_nested_error_is_wrapped_once():
    assert str(visit_error('$(var $(var $(nope)))')).count('Error trying') == 1


@pytest.mark.parametrize(
    ('text', 'call', 'near', 'is_known'),
    [
        ('$(var)', 'var', 'var', True),
        ('$(find_pkg_share p)', 'find_pkg_share', 'find-pkg-share', False),
        ('$(qqqqqq p)', 'qqqqqq', None, False),
    ],
)
def test_a_wrong_name_comes_with_what_was_meant(text, call, near, is_known):
    found = facts_of(visit_error(text))
    assert found == {'about': 'launch.call', 'call': call, 'near': near, 'is_known': is_known}


def test_equal_texts_share_built_in_substitutions_in_lists_of_their_own():
    first, second = parse_substitution('a$(var x)'), parse_substitution('a$(var x)')
    assert first is not second
    assert list(map(id, first)) == list(map(id, second))


def test_substitutions_of_extensions_are_made_anew():
    substitution_parse_methods['mine'] = lambda arguments: (TextSubstitution, {'text': 'x'})
    try:
        for text in ('$(mine)', '$(var $(mine))'):
            assert parse_substitution(text)[0] is not parse_substitution(text)[0]
    finally:
        del substitution_parse_methods['mine']


def test_only_texts_with_a_call_become_substitutions():
    assert parse_if_substitutions('plain') == 'plain'
    assert parse_if_substitutions(r'\$(var x)') == '$(var x)'
    assert parse_if_substitutions('') == ''
    assert parse_if_substitutions(1.5) == 1.5
    plain, made = parse_if_substitutions(['a', 'b$(var c)'])
    assert plain == 'a'
    assert [part.describe() for part in made] == ["'b'", "LaunchConfig('c')"]


def test_escapes_can_be_removed_alone():
    assert replace_escaped_characters(r'\$(x) \\ \n') == r'$(x) \ n'


def test_a_syntax_error_is_no_visit_error():
    with pytest.raises(SubstitutionSyntaxError) as caught:
        parse_substitution('$(var x')
    assert not isinstance(caught.value, VisitError)


def test_the_items_of_a_list_are_of_one_type():
    assert parse_if_substitutions(['$(env HOME)', 1])[1] == 1
    with pytest.raises(ValueError, match='must be of one type'):
        parse_if_substitutions(['$(env HOME)', 1, 1.0])
