"""From YAML text to data."""

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from launch.utilities.yaml_reader import MAX_DEPTH, SAFE_DEPTH, _possible_depth, read, read_file

from edulaunch.engine.facts import facts_of
from tests.house import EXAMPLES

BOMB = 'a: &a [x, x, x, x, x, x, x, x, x, x]\n' + ''.join(
    f'{name}: &{name} [{", ".join(["*" + before] * 10)}]\n' for before, name in zip('abcdefgh', 'bcdefghi', strict=True)
)


def test_mappings_know_the_line_of_their_first_key():
    launch = read('launch:\n\n- node:\n    pkg: a\n- {arg: {name: x}}\n')
    assert launch.line == 1
    assert [item.line for item in launch['launch']] == [3, 5]
    assert launch['launch'][0]['node'].line == 4


def test_the_last_of_equal_keys_wins_as_in_pyyaml():
    assert read('{a: 1, a: 2}') == {'a': 2}


def test_merge_keys_work():
    assert read('x: &x {a: 1, b: 2}\ny: {<<: *x, b: 3}') == {'x': {'a': 1, 'b': 2}, 'y': {'a': 1, 'b': 3}}


@pytest.mark.parametrize(
    'text',
    [
        '[' * 200,
        '- ' * 200 + 'a',
        '[' * 100_000,
        '- ' * 50_000,
        '[ "]", ' * 50_000,
        '{a: ' * 100_000,
        '? ' * 50_000,
        'a: &a [*a]',
        'a: &a {b: *a}',
    ],
)
def test_nesting_has_a_limit(text):
    with pytest.raises((ValueError, yaml.YAMLError)):
        read(text)


def test_the_deepest_allowed_nesting_is_read():
    text = '[' * MAX_DEPTH + ']' * MAX_DEPTH
    assert read(text) == yaml.safe_load(text)
    with pytest.raises(ValueError, match='nested more than 100 levels deep'):
        read(f'[{text}]')


def depth_of(node):
    if isinstance(node, yaml.ScalarNode):
        return 1
    parts = [part for item in node.value for part in (item if isinstance(item, tuple) else (item,))]
    return 1 + max(map(depth_of, parts), default=0)


@settings(max_examples=4 * EXAMPLES)
@given(
    st.lists(st.sampled_from([*'[]{}#,a"\'', '\n', '\n ', '\n  ', '\r', ': ', '- ', '? ', 'a]]]: [', 'a:\n- ']), max_size=30).map(
        ''.join
    )
)
def test_the_quick_bound_of_the_depth_is_never_below_it(text):
    try:
        node = yaml.compose(text, Loader=yaml.SafeLoader)
    except yaml.YAMLError:
        return
    assert node is None or depth_of(node) <= _possible_depth(text)


def test_a_wide_text_is_not_mistaken_for_a_deep_one():
    assert len(read('[' + '[a], ' * SAFE_DEPTH + ']')) == SAFE_DEPTH


@pytest.mark.parametrize('text', [BOMB, BOMB.replace('[', '{<<: [').replace(']', ']}').replace('x', '{k: 1}')])
def test_aliases_cannot_multiply_the_text(text):
    with pytest.raises(ValueError, match='aliases multiply the text'):
        read(text)


def test_only_plain_data_is_made():
    with pytest.raises(yaml.YAMLError, match='could not determine a constructor'):
        read('!!python/object/apply:os.system [ls]')


@pytest.mark.parametrize(
    'text', ['a: 1\n---\nb: 2', 'a: b: c', '\t- a', '{? [a]: b}', '{{a: b}: c}', 'a: \x00', '@', '- !!map a']
)
def test_broken_texts_give_pyyaml_s_error(text):
    with pytest.raises(yaml.YAMLError) as expected:
        yaml.load(text, Loader=yaml.CSafeLoader)
    with pytest.raises(type(expected.value)):
        read(text)


def test_the_python_loader_stands_in_for_the_c_loader(monkeypatch):
    monkeypatch.delattr(yaml, 'CSafeLoader')
    assert read('- a: 1').pop().line == 1
    with pytest.raises(ValueError, match='nested more than'):
        read('[' * 50_000)


data = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text('ab: #-[]{}"\n\\'),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text('abc'), inner, max_size=3),
    max_leaves=10,
)


@settings(max_examples=60, deadline=None)
@given(data, st.booleans())
def test_what_was_written_is_read(value, flow):
    assert read(yaml.safe_dump(value, default_flow_style=flow)) == value


@pytest.mark.parametrize(
    ('text', 'message'),
    [
        (
            'launch:\n\t- log: {}\n',
            "while scanning for the next token\nfound character '\\t' that cannot start any token\n"
            '  in "/p/a.launch.yaml", line 2, column 1',
        ),
        (
            'launch:\n - a: {b: c\n',
            'while parsing a flow mapping\n  in "/p/a.launch.yaml", line 2, column 7\n'
            "expected ',' or '}', but got '<stream end>'\n  in \"/p/a.launch.yaml\", line 3, column 1",
        ),
        ('launch: !odd x\n', 'could not determine a constructor for the tag \'!odd\'\n  in "/p/a.launch.yaml", line 1, column 9'),
    ],
)
def test_errors_of_a_file_are_those_of_pyyaml_s_own_reader(text, message):
    with pytest.raises(yaml.YAMLError) as caught:
        read_file(text, '/p/a.launch.yaml')
    assert str(caught.value) == message


def test_only_short_files_are_read_again_for_a_better_error():
    with pytest.raises(yaml.YAMLError, match='unicode string'):
        read_file('a: b\n' * 30_000 + '@', '/p/a.launch.yaml')


def test_a_tab_is_told_in_words():
    with pytest.raises(yaml.YAMLError) as caught:
        read_file('launch:\n\t- log: {}\n', 'a')
    assert facts_of(caught.value)['about'] == 'launch.yaml-tab'
