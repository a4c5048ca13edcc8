"""Reading launch files of any format."""

import importlib.metadata
import io
import warnings

import launch_xml
import launch_yaml
import pytest
from launch.actions import LogInfo
from launch.frontend import Entity, InvalidFrontendLaunchFileError, Parser, expose_action
from launch.frontend import parser as parser_module
from launch.frontend.expose import action_parse_methods


def stream(text, name=None):
    it = io.StringIO(text)
    if name is not None:
        it.name = name
    return it


def test_the_name_of_the_file_decides_the_format(tmp_path):
    for name, text, expected in (
        ('a.launch.xml', '<launch/>', launch_xml.Parser),
        ('b.launch.yaml', 'launch: []', launch_yaml.Parser),
    ):
        (tmp_path / name).write_text(text)
        root, parser = Parser.load(str(tmp_path / name))
        assert (root.type_name, type(parser), parser.file) == ('launch', expected, str(tmp_path / name))


@pytest.mark.parametrize(('text', 'expected'), [('<launch/>', launch_xml.Parser), ('launch: []', launch_yaml.Parser)])
def test_without_a_telling_name_every_format_is_tried(text, expected):
    for name in (None, 'x.launch', 'x.txt'):
        assert type(Parser.load(stream(text, name))[1]) is expected


def test_formats_and_their_names():
    assert list(Parser.get_available_extensions())[:2] == ['xml', 'yaml']
    assert launch_xml.Parser.get_file_extensions() == {'launch.xml', 'xml', 'launch'}
    assert launch_yaml.Parser.may_parse('x.launch.yml')
    assert not launch_yaml.Parser.may_parse('x.xml')
    assert Parser.get_parsers_from_filename('x.launch') == [launch_xml.Parser, launch_yaml.Parser]
    assert Parser.is_filename_valid('x.yaml')
    assert not Parser.is_filename_valid('x.launch.py')
    assert {'launch.xml', 'yml'} <= set(Parser.get_file_extensions_from_parsers())


def test_what_no_format_reads_is_reported_with_each_format_s_reason():
    with pytest.raises(InvalidFrontendLaunchFileError) as caught:
        Parser.load(stream('<launch>', 'x.launch.xml'))
    assert str(caught.value) == (
        'Caught multiple exceptions when trying to load file of format [xml]:\n'
        ' - ParseError: no element found: line 1, column 8\n - RuntimeError: Expected only one root'
    )


def test_an_unknown_kind_of_file_says_only_that():
    with pytest.raises(InvalidFrontendLaunchFileError, match='^The launch file may have a syntax error, or its format'):
        Parser.load(stream('import os\ndef f():\n    pass', 'x.launch.py'))


def test_a_missing_file_is_python_s_error():
    with pytest.raises(FileNotFoundError, match=r"\[Errno 2\] No such file or directory: '/no/such/x.launch.xml'"):
        Parser.load('/no/such/x.launch.xml')


def test_bytes_that_are_no_text_are_reported(tmp_path):
    (tmp_path / 'x.launch.xml').write_bytes(b'\xff\xfe\x00')
    with pytest.raises(InvalidFrontendLaunchFileError, match='UnicodeDecodeError'):
        Parser.load(str(tmp_path / 'x.launch.xml'))


def test_the_root_is_launch(failure_of):
    assert str(failure_of('<robot/>', raises=RuntimeError)) == "Expected 'launch' as root tag"
    assert str(failure_of('robot: []', 'x.yaml', RuntimeError)) == "Expected 'launch' as root tag"


def test_a_launch_file_can_be_deprecated(describe):
    description = describe('<launch deprecated="use the other one"/>')
    assert (description.deprecated, description.deprecated_reason) == (True, 'use the other one')


def test_actions_know_file_and_line(describe):
    xml = describe('<launch>\n<group>\n\n<log message="a"/></group></launch>').entities[0]
    assert str(xml.origin) == 'robot.launch.xml:2'
    inner = [entity for entity in xml.get_sub_entities() if isinstance(entity, LogInfo)]
    assert str(inner[0].origin) == 'robot.launch.xml:4'
    yaml = describe('launch:\n\n- log:\n    message: a\n', 'x.launch.yaml').entities[0]
    assert str(yaml.origin) == 'x.launch.yaml:3'


def test_an_exposed_action_is_an_element(actions_of):
    @expose_action('greet')
    def parse_greeting(entity, parser):
        return LogInfo, {'msg': f'Hello {entity.get_attr("name")}'}

    try:
        assert actions_of('<greet name="you"/>')[0].msg[0].text == 'Hello you'
    finally:
        del action_parse_methods['greet']


class BadEntryPoint:
    name = 'broken'

    def load(self):
        raise ValueError('no')


@pytest.mark.parametrize(
    ('group', 'load', 'message'),
    [
        ('launch.frontend.launch_extension', 'load_launch_extensions', 'Failed to load the launch extension: broken'),
        ('launch.frontend.parser', 'load_parser_implementations', 'Failed to load the parser implementation: broken'),
    ],
)
def test_a_broken_extension_gives_a_warning(monkeypatch, group, load, message):
    monkeypatch.setattr(parser_module.importlib_metadata, 'entry_points', lambda: {group: [BadEntryPoint()]})
    monkeypatch.setattr(Parser, 'extensions_loaded', False)
    monkeypatch.setattr(Parser, 'frontend_parsers', None)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter('always')
        getattr(Parser, load)()
    assert [str(warning.message) for warning in caught] == [message]


def test_an_extension_brings_a_format(monkeypatch):
    class Shouting(launch_xml.Parser):
        @classmethod
        def get_file_extensions(cls):
            return {'loud'}

    class EntryPoint:
        name = 'loud'
        load = staticmethod(lambda: Shouting)

    monkeypatch.setattr(importlib.metadata, 'entry_points', lambda: {'launch.frontend.parser': [EntryPoint]})
    monkeypatch.setattr(Parser, 'frontend_parsers', None)
    root, parser = Parser.load(stream('<launch/>', 'x.loud'))
    assert isinstance(root, Entity)
    assert type(parser) is Shouting


def test_an_extension_builds_on_a_built_in_action(actions_of):
    from launch_ros.actions import Node

    @expose_action('my_node')
    class MyNode(Node):
        @classmethod
        def parse(cls, entity, parser):
            _, kwargs = super().parse(entity, parser)
            kwargs['package'] = 'mine'
            return cls, kwargs

    try:
        (it,) = actions_of('<my_node exec="e" if="true"><param name="a" value="1"/></my_node>')
    finally:
        del action_parse_methods['my_node']
    assert (type(it), it.node_package, it.condition is not None) == (MyNode, 'mine', True)


def test_an_extension_of_executable_reads_its_command_itself(actions_of):
    from launch.actions import ExecuteProcess

    @expose_action('my_executable')
    class MyExecutable(ExecuteProcess):
        @classmethod
        def parse(cls, entity, parser):
            _, kwargs = super().parse(entity, parser, ['cmd'])
            kwargs['cmd'] = ['echo', entity.get_attr('word')]
            return cls, kwargs

    try:
        (it,) = actions_of('<my_executable word="hi" shell="true"/>')
    finally:
        del action_parse_methods['my_executable']
    assert [word[0].describe() for word in it.cmd] == ["'echo'", "'hi'"]
