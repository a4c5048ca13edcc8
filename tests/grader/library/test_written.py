"""Advice has the format of the submitted launch file."""

from __future__ import annotations

import pytest
from edugrade.evidence import Evidence
from edugrade.library.written import (
    argument_as_namespace,
    declaration_of,
    default_of,
    name_of_node,
    node_of,
    parameter_of_node,
    remapping_to,
    value_of,
)
from edugrade.source import SubmittedText


def evidence(file: str) -> Evidence:
    return Evidence({}, {}, SubmittedText(file, ''))


@pytest.mark.parametrize(
    ('file', 'default', 'remapping'),
    [
        ('/a.launch.py', "default_value='kitchen'", "write remappings=[('chatter', '/news')] in the Node"),
        ('/a.launch.xml', 'default="kitchen"', 'write <remap from="chatter" to="/news"/> in the node'),
        ('/a.launch.yaml', 'default: "kitchen"', 'write remap: [{from: "chatter", to: "/news"}] in the node'),
        ('/a.launch.yml', 'default: "kitchen"', 'write remap: [{from: "chatter", to: "/news"}] in the node'),
    ],
)
def test_a_default_and_a_remapping(file: str, default: str, remapping: str) -> None:
    assert (default_of(evidence(file), 'kitchen'), remapping_to(evidence(file), '/news', 'chatter')) == (default, remapping)


def test_a_name_of_a_node_is_what_to_write() -> None:
    python, xml, yaml = (evidence(f'/a.launch.{ending}') for ending in ('py', 'xml', 'yaml'))
    assert (
        name_of_node(python, 'late', 'sim', 'turtlesim_node')
        == "write namespace='late' and name='sim' in the Node of turtlesim_node"
    )
    assert name_of_node(xml, '', 'driver', 'draw_square') == 'write name="driver" in the Node of draw_square'
    assert name_of_node(python, '', '', 'talker') == 'add a Node of talker'
    assert argument_as_namespace(yaml, 'room', 'listener') == 'write namespace: "$(var room)" in the Node of listener'


def test_an_xml_file_gets_no_python() -> None:
    run = evidence('/a.launch.xml')
    assert declaration_of(run, 'room', 'kitchen') == '<arg name="room" default="kitchen" description="..."/>'
    assert parameter_of_node(run, 'speed', value_of(run, 'fast')) == 'add <param name="speed" value="$(var fast)"/> to the node'
    assert node_of(run, 'turtlesim', 'mimic') == '<node pkg="turtlesim" exec="mimic"/>'


def test_a_file_in_markup_has_a_place_for_missing_things() -> None:
    assert SubmittedText('/a.launch.xml', '<?xml version="1.0"?>\n<launch>\n</launch>').place == ('/a.launch.xml', 2)
    assert SubmittedText('/a.launch.yaml', 'launch:\n').place == ('/a.launch.yaml', 1)
