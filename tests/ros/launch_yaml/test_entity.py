"""YAML values as parse functions see them."""

import pytest
from launch.frontend import Entity as BaseEntity
from launch.utilities.yaml_reader import read
from launch_yaml import Entity

from edulaunch.engine.facts import facts_of


def entity(text, type_name='x'):
    return Entity(read(text), type_name)


def test_values_must_have_the_type_already():
    it = entity('{a: 1, b: "1", c: [1, 2]}')
    assert it.get_attr('a', data_type=int) == 1
    assert it.get_attr('b', data_type=int) == '1'
    assert it.get_attr('c', data_type=list[int]) == [1, 2]
    message = "^Attribute 'a' of Entity 'x' expected to be of type '<class 'str'>', got '<class 'int'>'$"
    with pytest.raises(TypeError, match=message):
        it.get_attr('a')


@pytest.mark.parametrize(
    ('text', 'data_type', 'written'),
    [('1', str, "'1'"), ('true', str, "'true'"), ('[a, b]', str, "'a b'"), ('2', float, '2.0'), ('{a: 1}', float, None)],
)
def test_an_error_says_how_to_write_the_value(text, data_type, written):
    with pytest.raises(TypeError) as raised:
        entity(f'{{a: {text}}}').get_attr('a', data_type=data_type, can_be_str=False)
    assert facts_of(raised.value)['write'] == written


def test_a_mapping_is_called_a_dict():
    with pytest.raises(TypeError, match="got '<class 'dict'>'"):
        entity('{a: {b: 1}}').get_attr('a')


@pytest.mark.parametrize('text', ['{}', '[]', 'null', 'text with exec'])
def test_a_missing_key_is_an_error_unless_optional(text):
    it = entity(text, 'node')
    assert it.get_attr('exec', optional=True) is None
    with pytest.raises(AttributeError, match="^Can not find attribute 'exec' in Entity 'node'$"):
        it.get_attr('exec')


@pytest.mark.parametrize('text', ['{param: {name: a}}', '{param: a}', '{param: []}', '{param: [a]}', '{param: null}'])
def test_child_elements_are_a_list_of_mappings(text):
    message = "^Attribute 'param' of Entity 'node' expected to be a list of dictionaries.$"
    with pytest.raises(TypeError, match=message):
        entity(text, 'node').get_attr('param', data_type=list[BaseEntity])


def test_children_are_one_key_mappings_in_a_list():
    for text in ('- a: {}\n- b: {}', 'children:\n- a: {}\n- b: {}'):
        it = entity(text)
        assert [child.type_name for child in it.children] == ['a', 'b']
        it.assert_entity_completely_parsed()


def test_children_know_their_line():
    assert [child.line for child in entity('- a: {}\n\n- b:\n    c: 1').children] == [1, 3]


@pytest.mark.parametrize('text', ['[a]', '[{a: 1, b: 2}]', '[{}]', '[1]', '[null]', '[[a]]'])
def test_other_children_are_an_error(text):
    message = '^Subentities must be a dictionary with only one key, which is the entity type$'
    with pytest.raises(RuntimeError, match=message):
        entity(text).children  # noqa: B018


@pytest.mark.parametrize(('text', 'error'), [('{a: 1}', ValueError), ('null', TypeError), ('{children: a}', TypeError)])
def test_an_element_without_a_list_has_no_children(text, error):
    with pytest.raises(error, match='child'):
        entity(text, 'group').children  # noqa: B018


def test_what_nobody_asked_for_is_an_error():
    it = entity('{a: 1, zzz: 2, nmae: 3}', 'node')
    it.get_attr('a', data_type=int)
    with pytest.raises(ValueError, match=r"^Unexpected key\(s\) found in `node`: {'nmae', 'zzz'}$"):
        it.assert_entity_completely_parsed()
    with pytest.raises(ValueError, match='Unexpected nested entity'):
        entity('[a]', 'node').assert_entity_completely_parsed()


def test_an_element_must_have_something_even_if_it_is_empty():
    entity('{}', 'shutdown').assert_entity_completely_parsed()
    with pytest.raises(TypeError, match="^argument of type 'NoneType' is not iterable$") as caught:
        entity('null', 'shutdown').assert_entity_completely_parsed()
    assert facts_of(caught.value)['about'] == 'launch.yaml-nothing'


@pytest.mark.parametrize(
    ('text', 'expected'),
    [
        ('[{name: a, value: 1}, {value: x y, name: b}]', [('a', 1), ('b', 'x y')]),
        ('[{name: a}]', None),
        ('[name, value]', None),
        ('[{name: a, value: 1}, {name: a, value: 1, type: str}]', None),
        ('[{name: 1, value: 1}]', None),
        ('[{name: a, value: [1]}]', None),
        ('[]', None),
        ('{name: a, value: 1}', None),
    ],
)
def test_children_are_plain_pairs_when_there_is_nothing_else(text, expected):
    pairs = entity(f'{{param: {text}}}').plain_pairs('param', 'name', 'value', is_typed=True)
    assert (pairs and [pair[:2] for pair in pairs]) == expected


def test_both_of_an_untyped_pair_are_texts():
    assert entity('{remap: [{from: a, to: b}]}').plain_pairs('remap', 'from', 'to')[0][:2] == ('a', 'b')
    assert entity('{remap: [{from: a, to: 2}]}').plain_pairs('remap', 'from', 'to') is None
    assert entity('[remap]').plain_pairs('remap', 'from', 'to') is None
