"""XML elements as parse functions see them."""

import xml.etree.ElementTree as ET

import pytest
from launch.frontend import Entity as BaseEntity
from launch.frontend.entity import Entities
from launch_xml import Entity
from launch_xml.reader import read


def entity(text):
    return Entity(read(text))


def test_attributes_are_converted():
    it = entity('<x a="1" b="true" c="2.5" d="$(var e)"/>')
    assert it.get_attr('a') == '1'
    assert it.get_attr('a', data_type=int) == 1
    assert it.get_attr('b', data_type=bool) is True
    assert it.get_attr('c', data_type=float) == 2.5
    assert it.get_attr('d', data_type=int) == '$(var e)'
    assert it.get_attr('a', data_type=None) == 1


def test_lists_need_a_separator():
    it = entity('<x a="1,2" a-sep="," b="s;t" b-sep=";"/>')
    assert it.get_attr('a', data_type=list[int]) == [1, 2]
    assert it.get_attr('a', data_type=None) == [1, 2]
    assert it.get_attr('b', data_type=list[str]) == ['s', 't']
    it.assert_entity_completely_parsed()


def test_a_missing_attribute_is_an_error_unless_optional():
    it = entity('<node/>')
    assert it.get_attr('exec', optional=True) is None
    message = "^Attribute 'exec' of type '<class 'str'>' not found in Entity 'node'$"
    with pytest.raises(AttributeError, match=message):
        it.get_attr('exec')


def test_an_attribute_of_the_wrong_type_is_an_error():
    with pytest.raises(TypeError, match="Attribute 'a' of Entity 'x' expected to be of type '<class 'bool'>'"):
        entity('<x a="maybe"/>').get_attr('a', data_type=bool, can_be_str=False)


def test_children_are_found_by_name():
    it = entity('<node><param name="a"/><remap/><param name="b"/></node>')
    assert [child.get_attr('name') for child in it.get_attr('param', data_type=list[BaseEntity])] == ['a', 'b']
    assert it.get_attr('env', data_type=list[Entity], optional=True) is None
    with pytest.raises(AttributeError, match=r"of type 'typing\.List\[launch\.frontend\.entity\.Entity\]' not found"):
        it.get_attr('env', data_type=Entities)


def test_children_know_their_parent_and_line():
    it = entity('<launch>\n<node/>\n</launch>')
    (child,) = it.children
    assert (child.type_name, child.parent, child.line) == ('node', it, 2)


def test_what_nobody_asked_for_is_an_error():
    it = entity('<node zzz="1" pkg="a" nmae="b"><param/><bogus/></node>')
    it.get_attr('pkg')
    it.get_attr('param', data_type=list[BaseEntity])
    with pytest.raises(ValueError, match=r"^Unexpected nested tag\(s\) found in `node`: {'bogus'}$"):
        it.assert_entity_completely_parsed()
    it.get_attr('bogus', data_type=list[BaseEntity])
    with pytest.raises(ValueError, match=r"^Unexpected attribute\(s\) found in `node`: {'nmae', 'zzz'}$"):
        it.assert_entity_completely_parsed()


@pytest.mark.parametrize(
    ('text', 'what'),
    [('<x p="1"/>', r"attribute\(s\) found in `x`: {'p'}"), ('<x><a/></x>', r"nested tag\(s\) found in `x`: {'a'}")],
)
def test_to_ask_for_an_attribute_is_not_to_ask_for_a_child_of_that_name(text, what):
    it = entity(text)
    assert it.get_attr('a', optional=True) is None
    assert it.get_attr('p', data_type=Entities, optional=True) is None
    with pytest.raises(ValueError, match=what):
        it.assert_entity_completely_parsed()


def test_elements_of_the_standard_library_will_do():
    it = Entity(ET.fromstring('<x a="1"><y/></x>'))
    assert (it.type_name, it.get_attr('a'), it.children[0].type_name, it.line) == ('x', '1', 'y', 0)


@pytest.mark.parametrize(
    ('text', 'expected'),
    [
        ('<p name="a" value="1"/><q/><p value="x y" name="b"/>', [('a', 1), ('b', 'x y')]),
        ('<p name="a"/>', None),
        ('<q/>', None),
        ('<p name="a" value="1"/><p name="a" value="1" type="str"/>', None),
        ('<p name="a" value="1"><p/></p>', None),
        ('<p name="a" other="1"/>', None),
    ],
)
def test_children_are_plain_pairs_when_there_is_nothing_else(text, expected):
    pairs = entity(f'<node>{text}</node>').plain_pairs('p', 'name', 'value', is_typed=True)
    assert (pairs and [pair[:2] for pair in pairs]) == expected


def test_both_of_an_untyped_pair_are_texts():
    assert entity('<node>\n<remap from="1" to="2"/></node>').plain_pairs('remap', 'from', 'to') == [('1', '2', 2)]
