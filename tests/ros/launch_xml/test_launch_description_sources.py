"""Launch descriptions from XML and YAML files."""

import pytest
from launch import LaunchContext
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch_xml.launch_description_sources import XMLLaunchDescriptionSource
from launch_yaml.launch_description_sources import YAMLLaunchDescriptionSource

XML = '<launch><arg name="x" default="1"/></launch>'
YAML = 'launch:\n- arg: {name: x, default: "1"}\n'


@pytest.mark.parametrize(
    ('name', 'text', 'source_class', 'method'),
    [
        ('a.launch.xml', XML, XMLLaunchDescriptionSource, 'interpreted XML launch file'),
        ('a.launch.yaml', YAML, YAMLLaunchDescriptionSource, 'interpreted YAML launch file'),
    ],
)
def test_a_file_becomes_a_description(tmp_path, name, text, source_class, method):
    path = tmp_path / name
    path.write_text(text)
    for source in (source_class(str(path)), AnyLaunchDescriptionSource(str(path))):
        description = source.get_launch_description(LaunchContext())
        assert [argument.name for argument in description.get_launch_arguments()] == ['x']
    assert source_class(str(path)).method == method


def test_an_action_points_to_its_file(tmp_path):
    path = tmp_path / 'a.launch.xml'
    path.write_text('<launch>\n\n<log message="a"/></launch>')
    description = XMLLaunchDescriptionSource(str(path)).get_launch_description(LaunchContext())
    assert str(description.entities[0].origin) == f'{path}:3'
