"""The line of help below each mistake in XML and YAML launch files: golden texts."""

# ruff: noqa: E501
import io

import pytest
from launch._failure import failure_data
from launch.frontend import InvalidFrontendLaunchFileError, Parser

from edulaunch.advice.rendering import help_of

MISTAKES = {
    'robot.launch.xml': [
        ('<launch>\n\n<nodee/></launch>', '3: <nodee> is not an element of launch files; write <node>'),
        (
            '<launch><zzzz/></launch>',
            '1: <zzzz> is not an element of launch files; use another element, such as node, include, arg, group, let, log, timer or executable',
        ),
        ('<launch><rosparam/></launch>', '1: ROS 1 had the element <rosparam>, but ROS 2 does not; write <param>'),
        (
            '<launch><machine/></launch>',
            '1: ROS 1 had the element <machine>, but ROS 2 does not; remove it: ROS 2 has no equivalent of <machine>',
        ),
        (
            '<launch>\n<node pkg="a" exec="b" nmae="c"></node>\n</launch>',
            "2: <node> has no attribute or element 'nmae'; write 'name'",
        ),
        (
            '<launch>\n<node pkg="a" exec="b" type="c"></node>\n</launch>',
            "2: <node> has no attribute or element 'type'; write 'exec'",
        ),
        (
            '<launch>\n<node pkg="a" exec="b" ><parm/></node>\n</launch>',
            "2: <node> has no attribute or element 'parm'; write 'param'",
        ),
        (
            '<launch>\n<node pkg="a" exec="b" param="c"></node>\n</launch>',
            "2: 'param' is an element inside <node>, not an attribute; write it as an element inside <node>",
        ),
        (
            '<launch>\n<node pkg="a" exec="b" ><output/></node>\n</launch>',
            '2: \'output\' is an attribute of <node>, not an element inside it; write it as an attribute: output="..."',
        ),
        ('<launch>\n<node pkg="a" exec="b" >\n<remap from="c"/></node>\n</launch>', "3: <remap> needs 'to'; add 'to'"),
        ('<launch>\n<node pkg="a" exec="b" >\n<param name="c"/></node>\n</launch>', "3: <param> needs 'value'; add 'value'"),
        (
            '<launch>\n<node pkg="a" exec="b" >\n<param file="c"/></node>\n</launch>',
            "3: <param> needs a name and a value, or a file; add name and value, or from='a file'",
        ),
        (
            '<launch>\n<remap from="a" to="b"/></launch>',
            '2: <remap> must be inside <node>, not on its own; move it into <node>, or write <set_remap> to apply it to everything that follows',
        ),
        ('<launch>\n<choice value="a"/></launch>', '2: <choice> must be inside <arg>, not on its own; move it into <arg>'),
        (
            '<launch>\n<composable_node/></launch>',
            '2: <composable_node> must be inside <node_container>, <load_composable_node>, not on its own; move it into <node_container>, <load_composable_node>',
        ),
        ('<launch>\n<node executable="a"/></launch>', "2: <node> needs 'exec'; replace 'executable' with 'exec'"),
        ('<launch>\n<let name="a" default="b"/></launch>', "2: <let> needs 'value'; replace 'default' with 'value'"),
        (
            '<launch>\n<include file="a"><param name="b" value="c"/></include></launch>',
            "2: <include> has no attribute or element 'param'; write 'arg'",
        ),
        (
            '<launch>\n<log message="$(eval 1 == 1)"/></launch>',
            "2: the syntax of $(eval ...) is not valid; put the whole expression in quotes: $(eval '...')",
        ),
        (
            '<launch>\n<executable cmd="ls &quot;a $(var b)&quot;"/></launch>',
            "2: a quote in 'ls \"a ' is not closed; close the quote before a $(...) begins",
        ),
        ('', "1: this launch file is empty; start the file with <launch>, or in YAML with 'launch:' and a list below it"),
        ('<launch>\n<node pkg="a"/></launch>', "2: <node> needs 'exec'; add 'exec'"),
        ('<launch>\n<node pkg="a" exce="b"/></launch>', "2: <node> needs 'exec'; replace 'exce' with 'exec'"),
        ('<launch>\n<timer perid="1.0"/></launch>', "2: <timer> needs 'period'; replace 'perid' with 'period'"),
        ('<launch><group>\n<let name="a"/></group></launch>', "2: <let> needs 'value'; add 'value'"),
        (
            '<launch>\n<log message="$(find a)"/></launch>',
            '2: $(find ...) is a substitution of ROS 1; in ROS 2 it is $(find-pkg-share ...); write $(find-pkg-share ...)',
        ),
        (
            '<launch>\n<log message="$(var x"/></launch>',
            "2: launch cannot read '$(var x': at column 8, it expects one space and an argument, or ')'; check that brackets are closed, that quotes come in pairs, and that one space precedes each argument",
        ),
        (
            '<launch>\n<group>\n</launch>',
            '3: the element <group> that starts on line 2 is not closed; write </group> where the element ends',
        ),
        ('<robot/>', "1: the outermost element is <robot>, not 'launch'; put everything into one element named 'launch'"),
    ],
    'x.yaml': [
        ('launch:\n- nodee: {}', "2: 'nodee' is not an element of launch files; write 'node'"),
        ('launch:\n- node: {exec: a, nmae: b}', "2: 'node' has no attribute or element 'nmae'; write 'name'"),
        ('launch:\n- arg:\n    default: a', "2: 'arg' needs 'name'; add 'name'"),
        ('launch:\n- let: {name: a, valu: b}', "2: 'let' needs 'value'; replace 'valu' with 'value'"),
        ('launch:\n- arg: {name: a, default: 1}', "2: the value of 'default' has the wrong type for 'arg'; write default: '1'"),
        (
            'launch:\n- executable: {cmd: [ls, -l]}',
            "2: the value of 'cmd' has the wrong type for 'executable'; write cmd: 'ls -l'",
        ),
        (
            'launch:\n- timer: {period: 5, children: []}',
            "2: the value of 'period' has the wrong type for 'timer'; write period: 5.0",
        ),
        (
            'launch:\n- executable: {cmd: ls, shell: 1}',
            "2: the value of 'shell' has the wrong type for 'executable'; write shell: true",
        ),
        (
            'launch:\n  node: {exec: a}',
            "1: the actions in 'launch' must be a list; start each action with a dash, as in `- node: ...`",
        ),
        (
            'launch:\n- timer: {period: 5.0, actions: []}',
            "2: the actions in 'timer' must be a list; put the actions into a list below 'children:'",
        ),
        (
            'launch:\n- node:\n  - pkg: a\n  - exec: b',
            "2: the keys of 'node' are written as a list; remove the dashes, as in `exec: ...`",
        ),
        ('launch:\n- include: /a/b', "2: 'include' has a value without a key; the key is 'file'; write include: {file: '/a/b'}"),
        (
            'launch:\n- node: {exec: a, param: {name: b}}',
            "2: 'param' of 'node' must be a list; start each item with a dash, as in `- {...}`",
        ),
        (
            'launch:\n- node: {exec: a, output: "screen}',
            '2: launch cannot read this file: found unexpected end of stream; check brackets, quotes and indentation in that line and in the line above',
        ),
        (
            'launch: 3',
            "1: 'launch' must contain a list; write a list below it, and start each item with a dash, as in `- node: ...`",
        ),
        (
            'launch:\n- node: {exec: a}\n  log: {message: a}',
            "2: one item of 'launch' contains several elements: node, log; write a dash before each of node, log, and indent the keys below each by two more spaces",
        ),
        (
            'launch:\n- group:\n  - a',
            "2: an item of 'group' is not an element; write the name of the element with a colon and its content below it, as in `- node: ...`",
        ),
    ],
}


@pytest.mark.parametrize(('name', 'text', 'told'), [(name, *row) for name, rows in MISTAKES.items() for row in rows])
def test_an_error_says_where_and_what_was_meant(name, text, told):
    stream = io.StringIO(text)
    stream.name = name
    with pytest.raises(Exception) as caught:
        root, parser = Parser.load(stream)
        parser.parse_description(root)
    data = failure_data(caught.value)
    assert f'{data["place"].line}: {help_of(data)}' == told and data['place'].file == name


@pytest.mark.parametrize(
    ('content', 'line', 'told'),
    [
        (b'', 1, "this launch file is empty; start the file with <launch>, or in YAML with 'launch:' and a list below it"),
        (
            b'- node: {exec: a}',
            1,
            "the file does not begin with 'launch:'; start the file with 'launch:' and indent everything else below it",
        ),
        (
            b'launch: []\nnode: {}',
            1,
            "the top level of the file has launch, node, but only 'launch' is allowed there; start the file with 'launch:' "
            'and indent everything else below it',
        ),
        (b'launch:\n- log: {message: \xff}', 2, 'this file is not encoded in UTF-8; save the file again in UTF-8'),
    ],
)
def test_an_error_of_the_whole_text_has_a_line_too(tmp_path, content, line, told):
    path = tmp_path / 'x.launch.yaml'
    path.write_bytes(content)
    with pytest.raises(InvalidFrontendLaunchFileError) as caught:
        Parser.load(str(path))
    data = failure_data(caught.value)
    assert (data['place'], help_of(data)) == ((str(path), line), told)
