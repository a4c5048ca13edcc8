"""From XML text to elements."""

import xml.etree.ElementTree as ET

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from launch_xml.reader import MAX_DEPTH, read

from edulaunch.engine.facts import facts_of

BOMB = '<!DOCTYPE l [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]><launch>&b;</launch>'


def outline(element):
    return [element.tag, dict(element.attrib), [outline(child) for child in element]]


def test_elements_know_their_line():
    root = read('<launch>\n  <group>\n\n    <node\n       pkg="a"/></group>\n</launch>')
    assert (root.tag, root.line) == ('launch', 1)
    assert (root[0].tag, root[0].line) == ('group', 2)
    assert (root[0][0].tag, root[0][0].line, root[0][0].attrib) == ('node', 4, {'pkg': 'a'})


@pytest.mark.parametrize(
    'text',
    [
        '',
        '<a>',
        '<a></b>',
        '<a b="1" b="2"/>',
        'x<a/>',
        '<a/>x',
        '<a>&foo;</a>',
        '<a b="&foo;"/>',
        '<x:a/>',
        '<a b=1/>',
        '<a>\x00</a>',
        '<!DOCTYPE a SYSTEM "nowhere.dtd"><a>\n&foo;</a>',
    ],
)
def test_broken_texts_are_reported_as_the_standard_library_does(text):
    with pytest.raises(ET.ParseError) as expected:
        ET.fromstring(text)
    with pytest.raises(ET.ParseError) as caught:
        read(text)
    assert str(caught.value) == str(expected.value)
    assert caught.value.position == expected.value.position


@pytest.mark.parametrize(
    'text',
    [
        BOMB,
        '<!DOCTYPE l [<!ENTITY x SYSTEM "file:///etc/passwd">]><launch>&x;</launch>',
        '<!DOCTYPE l [<!ENTITY % p SYSTEM "http://example.org/x"> %p;]><launch/>',
    ],
)
def test_declared_entities_are_refused(text):
    with pytest.raises(ValueError, match='is declared; launch files must not declare entities'):
        read(text)


def test_nesting_has_a_limit():
    assert read('<a>' * MAX_DEPTH + '</a>' * MAX_DEPTH).tag == 'a'
    with pytest.raises(ValueError, match='nested more than 100 levels deep') as caught:
        read('<a>\n' * (MAX_DEPTH + 1) + '</a>' * (MAX_DEPTH + 1))
    assert caught.value.edulaunch_line == MAX_DEPTH + 1


def test_what_is_not_closed_is_named():
    with pytest.raises(ET.ParseError) as caught:
        read('<launch>\n<group>\n<node/>\n</launch>')
    assert facts_of(caught.value) == {'about': 'launch.not-closed', 'tag': 'group', 'opened': 2}


def test_namespaces_are_written_as_the_standard_library_writes_them():
    text = '<l xmlns="urn:x" xmlns:y="urn:y" y:a="1"><y:b/></l>'
    root, expected = read(text), ET.fromstring(text)
    assert outline(root) == outline(expected)


names = st.from_regex(r'[a-z][a-z0-9_-]{0,5}', fullmatch=True)
elements = st.recursive(
    st.builds(lambda tag, attributes: ET.Element(tag, attributes), names, st.dictionaries(names, st.text('ab<&"\n'))),
    lambda inner: st.builds(
        lambda parent, children: (parent.extend(children), parent)[1], st.builds(ET.Element, names), st.lists(inner, max_size=3)
    ),
    max_leaves=8,
)


@settings(max_examples=60, deadline=None)
@given(elements)
def test_what_was_written_is_read(element):
    assert outline(read(ET.tostring(element, encoding='unicode'))) == outline(element)
