"""The line of help below each mistake in XML and YAML launch files: golden texts."""

# ruff: noqa: E501
import io

import pytest
from launch._failure import failure_data
from launch.frontend import InvalidFrontendLaunchFileError, Parser

from edulaunch.advice.wording import help_of

MISTAKES = {
    'robot.launch.xml': [
        ('<launch>\n\n<nodee/></launch>', '3: <nodee> is no launch element; write <node>'),
        (
            '<launch><zzzz/></launch>',
            '1: <zzzz> is no launch element; choose another one, such as node, include, arg, group, let, log, timer or executable',
        ),
        ('<launch><rosparam/></launch>', '1: <rosparam> is an element of ROS 1; write <param>'),
        ('<launch><machine/></launch>', '1: <machine> is an element of ROS 1; take it out: ROS 2 has nothing like <machine>'),
        ('<launch>\n<node pkg="a" exec="b" nmae="c"></node>\n</launch>', "2: <node> knows no 'nmae'; write 'name'"),
        ('<launch>\n<node pkg="a" exec="b" type="c"></node>\n</launch>', "2: <node> knows no 'type'; write 'exec'"),
        ('<launch>\n<node pkg="a" exec="b" ><parm/></node>\n</launch>', "2: <node> knows no 'parm'; write 'param'"),
        (
            '<launch>\n<node pkg="a" exec="b" param="c"></node>\n</launch>',
            "2: <node> has no attribute 'param': that is an element inside it; write it as an element inside <node>",
        ),
        (
            '<launch>\n<node pkg="a" exec="b" ><output/></node>\n</launch>',
            '2: <node> has no element \'output\': that is an attribute of it; write it as an attribute: output="..."',
        ),
        ('<launch>\n<node pkg="a" exec="b" >\n<remap from="c"/></node>\n</launch>', "3: <remap> needs 'to'; add 'to'"),
        ('<launch>\n<node pkg="a" exec="b" >\n<param name="c"/></node>\n</launch>', "3: <param> needs 'value'; add 'value'"),
        (
            '<launch>\n<node pkg="a" exec="b" >\n<param file="c"/></node>\n</launch>',
            "3: <param> has neither a name nor a file; give it name and value, or from='a file'",
        ),
        (
            '<launch>\n<remap from="a" to="b"/></launch>',
            '2: <remap> stands here by itself, and belongs inside <node>; put it inside <node>, or write <set_remap> for everything that follows',
        ),
        (
            '<launch>\n<choice value="a"/></launch>',
            '2: <choice> stands here by itself, and belongs inside <arg>; put it inside <arg>',
        ),
        (
            '<launch>\n<composable_node/></launch>',
            '2: <composable_node> stands here by itself, and belongs inside <node_container>, <load_composable_node>; put it inside <node_container>, <load_composable_node>',
        ),
        ('<launch>\n<node executable="a"/></launch>', "2: <node> needs 'exec'; write 'exec' where you wrote 'executable'"),
        ('<launch>\n<let name="a" default="b"/></launch>', "2: <let> needs 'value'; write 'value' where you wrote 'default'"),
        (
            '<launch>\n<include file="a"><param name="b" value="c"/></include></launch>',
            "2: <include> knows no 'param'; write 'arg'",
        ),
        (
            '<launch>\n<log message="$(eval 1 == 1)"/></launch>',
            "2: $(eval ...) is not written as it has to be; put the whole expression into quotes: $(eval '...')",
        ),
        (
            '<launch>\n<executable cmd="ls &quot;a $(var b)&quot;"/></launch>',
            "2: in 'ls \"a ' a quote is not closed; close it before a $(...) begins",
        ),
        ('', "1: the launch file is empty; begin it with <launch>, or in YAML with 'launch:' and a list below"),
        ('<launch>\n<node pkg="a"/></launch>', "2: <node> needs 'exec'; add 'exec'"),
        ('<launch>\n<node pkg="a" exce="b"/></launch>', "2: <node> needs 'exec'; write 'exec' where you wrote 'exce'"),
        ('<launch>\n<timer perid="1.0"/></launch>', "2: <timer> needs 'period'; write 'period' where you wrote 'perid'"),
        ('<launch><group>\n<let name="a"/></group></launch>', "2: <let> needs 'value'; add 'value'"),
        (
            '<launch>\n<log message="$(find a)"/></launch>',
            '2: $(find ...) is of ROS 1; here it is $(find-pkg-share ...); write $(find-pkg-share ...)',
        ),
        (
            '<launch>\n<log message="$(var x"/></launch>',
            "2: '$(var x' cannot be read: at column 8 comes something else than one space and an argument, or ')'; look there: brackets closed, one space before each argument, quotes in pairs",
        ),
        ('<launch>\n<group>\n</launch>', '3: <group> of line 2 is not closed; write </group> where it ends'),
        ('<robot/>', "1: the outermost element is <robot>, not 'launch'; put everything into one element called launch"),
    ],
    'x.yaml': [
        ('launch:\n- nodee: {}', "2: 'nodee' is no launch element; write 'node'"),
        ('launch:\n- node: {exec: a, nmae: b}', "2: 'node' knows no 'nmae'; write 'name'"),
        ('launch:\n- arg:\n    default: a', "2: 'arg' needs 'name'; add 'name'"),
        ('launch:\n- let: {name: a, valu: b}', "2: 'let' needs 'value'; write 'value' where you wrote 'valu'"),
        (
            'launch:\n- arg: {name: a, default: 1}',
            "2: the value of 'default' is of another type than 'arg' takes; write default: '1'",
        ),
        (
            'launch:\n- executable: {cmd: [ls, -l]}',
            "2: the value of 'cmd' is of another type than 'executable' takes; write cmd: 'ls -l'",
        ),
        (
            'launch:\n- timer: {period: 5, children: []}',
            "2: the value of 'period' is of another type than 'timer' takes; write period: 5.0",
        ),
        (
            'launch:\n- executable: {cmd: ls, shell: 1}',
            "2: the value of 'shell' is of another type than 'executable' takes; write shell: true",
        ),
        ('launch:\n  node: {exec: a}', "1: 'launch' has its actions without a list; begin each of them with a dash: - node: ..."),
        (
            'launch:\n- timer: {period: 5.0, actions: []}',
            "2: 'timer' has its actions without a list; put them into a list below 'children:'",
        ),
        ('launch:\n- node:\n  - pkg: a\n  - exec: b', "2: the keys of 'node' stand in a list; take the dashes away: exec: ..."),
        ('launch:\n- include: /a/b', "2: 'include' has a bare value, and needs the key 'file'; write include: {file: '/a/b'}"),
        (
            'launch:\n- node: {exec: a, param: {name: b}}',
            "2: 'param' of 'node' needs a list; begin each item with a dash: - {...}",
        ),
        (
            'launch:\n- node: {exec: a, output: "screen}',
            '2: the file cannot be read: found unexpected end of stream; look at that line and the one above it: brackets, quotes, indentation',
        ),
        ('launch: 3', "1: 'launch' needs a list; put a list below it, each item with a dash: - node: ..."),
        (
            'launch:\n- node: {exec: a}\n  log: {message: a}',
            "2: node, log stand in one item of 'launch'; write a dash for each of node, log, and its keys two columns further",
        ),
        (
            'launch:\n- group:\n  - a',
            "2: an item of 'group' is no element; write the element's name with a colon, and below it what it has: - node: ...",
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
        (b'', 1, "the launch file is empty; begin it with <launch>, or in YAML with 'launch:' and a list below"),
        (
            b'- node: {exec: a}',
            1,
            "the file does not begin with 'launch:'; begin the file with 'launch:' and put everything else below it",
        ),
        (
            b'launch: []\nnode: {}',
            1,
            "at the left margin stand launch, node; only 'launch' may stand there; begin the file with 'launch:' "
            'and put everything else below it',
        ),
        (b'launch:\n- log: {message: \xff}', 2, 'the file is not UTF-8 text; save the file again with the encoding UTF-8'),
    ],
)
def test_an_error_of_the_whole_text_has_a_line_too(tmp_path, content, line, told):
    path = tmp_path / 'x.launch.yaml'
    path.write_bytes(content)
    with pytest.raises(InvalidFrontendLaunchFileError) as caught:
        Parser.load(str(path))
    data = failure_data(caught.value)
    assert (data['place'], help_of(data)) == ((str(path), line), told)
