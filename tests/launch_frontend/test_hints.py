"""The line of help after an error in a launch file."""

import pytest
from launch._help import help_line
from launch.frontend import InvalidFrontendLaunchFileError, Parser

IN_NODE = '<launch>\n<node pkg="a" exec="b" {}>{}</node>\n</launch>'


@pytest.mark.parametrize(
    ('text', 'help_line'),
    [
        ('<launch>\n\n<nodee/></launch>', 'robot.launch.xml:3: <nodee> is no launch element; did you mean <node>?'),
        ('<launch><zzzz/></launch>', 'robot.launch.xml:1: <zzzz> is no launch element'),
        ('<launch><rosparam/></launch>', "robot.launch.xml:1: <rosparam> is an element of ROS 1; 'param' does this in ROS 2"),
        ('<launch><machine/></launch>', 'robot.launch.xml:1: <machine> is an element of ROS 1; ROS 2 has nothing like it'),
        (IN_NODE.format('nmae="c"', ''), "robot.launch.xml:2: <node> knows no 'nmae'; did you mean 'name'?"),
        (IN_NODE.format('type="c"', ''), "robot.launch.xml:2: <node> knows no 'type'; did you mean 'exec'?"),
        (IN_NODE.format('', '<parm/>'), "robot.launch.xml:2: <node> knows no 'parm'; did you mean 'param'?"),
        (IN_NODE.format('param="c"', ''), "robot.launch.xml:2: 'param' is an element inside <node>"),
        (IN_NODE.format('', '<output/>'), "robot.launch.xml:2: 'output' is an attribute of <node>"),
        (IN_NODE.format('', '\n<remap from="c"/>'), "robot.launch.xml:3: <remap> needs the attribute 'to'"),
        (IN_NODE.format('', '\n<param name="c"/>'), "robot.launch.xml:3: <param> needs 'value' beside its name"),
        (IN_NODE.format('', '\n<param file="c"/>'), "robot.launch.xml:3: give it name and value, or from='a file'"),
        (
            '<launch>\n<remap from="a" to="b"/></launch>',
            'robot.launch.xml:2: <remap> stands inside <node>; for everything that follows there is <set_remap>',
        ),
        ('<launch>\n<choice value="a"/></launch>', 'robot.launch.xml:2: <choice> stands inside <arg>'),
        (
            '<launch>\n<composable_node/></launch>',
            'robot.launch.xml:2: <composable_node> stands inside <node_container> or <load_composable_node>',
        ),
        (
            '<launch>\n<node executable="a"/></launch>',
            "robot.launch.xml:2: <node> needs the attribute 'exec'; is 'executable' meant for it?",
        ),
        (
            '<launch>\n<let name="a" default="b"/></launch>',
            "robot.launch.xml:2: <let> needs the attribute 'value'; is 'default' meant for it?",
        ),
        (
            '<launch>\n<include file="a"><param name="b" value="c"/></include></launch>',
            "robot.launch.xml:2: <include> knows no 'param'; did you mean 'arg'?",
        ),
        (
            '<launch>\n<log message="$(eval 1 == 1)"/></launch>',
            "robot.launch.xml:2: put the whole expression into quotes: $(eval '...')",
        ),
        (
            '<launch>\n<executable cmd="ls &quot;a $(var b)&quot;"/></launch>',
            "robot.launch.xml:2: in 'ls \"a ' a quote is not closed; close it before a $(...) begins",
        ),
        ('', 'robot.launch.xml:1: the file has no element: begin it with <launch> and end it with </launch>'),
        ('<launch>\n<node pkg="a"/></launch>', "robot.launch.xml:2: <node> needs the attribute 'exec'"),
        (
            '<launch>\n<node pkg="a" exce="b"/></launch>',
            "robot.launch.xml:2: <node> needs the attribute 'exec'; is 'exce' meant for it?",
        ),
        (
            '<launch>\n<timer perid="1.0"/></launch>',
            "robot.launch.xml:2: <timer> needs the attribute 'period'; is 'perid' meant for it?",
        ),
        ('<launch><group>\n<let name="a"/></group></launch>', "robot.launch.xml:2: <let> needs the attribute 'value'"),
        (
            '<launch>\n<log message="$(find a)"/></launch>',
            'robot.launch.xml:2: write $(find-pkg-share ...) instead of $(find ...)',
        ),
        (
            '<launch>\n<log message="$(var x"/></launch>',
            "robot.launch.xml:2: expected one space and an argument, or ')' at column 8 of '$(var x'",
        ),
        ('<launch>\n<group>\n</launch>', 'robot.launch.xml:3: <group> of line 2 is not closed'),
        ('<robot/>', "robot.launch.xml:1: the outermost element is <robot>, not 'launch'"),
    ],
)
def test_an_error_in_xml_says_where_and_what_was_meant(failure_of, text, help_line):
    assert failure_of(text).edulaunch_help == help_line


@pytest.mark.parametrize(
    ('text', 'help_line'),
    [
        ('launch:\n- nodee: {}', "x.yaml:2: 'nodee' is no launch element; did you mean 'node'?"),
        ('launch:\n- node: {exec: a, nmae: b}', "x.yaml:2: 'node' knows no 'nmae'; did you mean 'name'?"),
        ('launch:\n- arg:\n    default: a', "x.yaml:2: 'arg' needs the key 'name'"),
        ('launch:\n- let: {name: a, valu: b}', "x.yaml:2: 'let' needs the key 'value'; is 'valu' meant for it?"),
        ('launch:\n- arg: {name: a, default: 1}', "x.yaml:2: write the value of 'default' in quotes"),
        ('launch:\n- executable: {cmd: [ls, -l]}', "x.yaml:2: write 'cmd' as one text: cmd: 'ls -l'"),
        ('launch:\n- timer: {period: 5, children: []}', 'x.yaml:2: write period: 5.0'),
        ('launch:\n- executable: {cmd: ls, shell: 1}', 'x.yaml:2: write shell: true, or shell: false'),
        ('launch:\n  node: {exec: a}', "x.yaml:1: begin each element in 'launch' with a dash: - node: ..."),
        ('launch:\n- timer: {period: 5.0, actions: []}', "x.yaml:2: put the actions of 'timer' into a list below 'children:'"),
        ('launch:\n- node:\n  - pkg: a\n  - exec: b', "x.yaml:2: the keys of 'node' have no dashes: exec: ..."),
        ('launch:\n- include: /a/b', "x.yaml:2: write include: {file: '/a/b'}"),
        ('launch:\n- node: {exec: a, param: {name: b}}', "x.yaml:2: begin each 'param' with a dash: - {...}"),
        ('launch:\n- node: {exec: a, output: "screen}', 'x.yaml:2: found unexpected end of stream'),
        ('launch: 3', "x.yaml:1: put a list below 'launch', each item with a dash: - node: ..."),
        (
            'launch:\n- node: {exec: a}\n  log: {message: a}',
            "x.yaml:2: 'node', 'log' stand in one item: a dash for each element, its keys two columns further",
        ),
        (
            'launch:\n- group:\n  - a',
            "x.yaml:2: each item of 'group' is an element's name with a colon and what it has: - node: ...",
        ),
    ],
)
def test_an_error_in_yaml_does_so_too(failure_of, text, help_line):
    assert failure_of(text, 'x.yaml').edulaunch_help == help_line


@pytest.mark.parametrize(
    ('content', 'line', 'hint'),
    [
        (b'', 1, "the file is empty: begin it with 'launch:' and a list of actions below"),
        (b'- node: {exec: a}', 1, "begin the file with 'launch:' and put everything else below it"),
        (b'launch: []\nnode: {}', 1, "only 'launch' may stand at the left margin, not 'launch', 'node'"),
        (b'launch:\n- log: {message: \xff}', 2, 'save the file as UTF-8'),
    ],
)
def test_an_error_of_the_whole_text_has_a_line_too(tmp_path, content, line, hint):
    path = tmp_path / 'x.launch.yaml'
    path.write_bytes(content)
    with pytest.raises(InvalidFrontendLaunchFileError) as caught:
        Parser.load(str(path))
    assert help_line(caught.value) == f'  help: {path}:{line}: {hint}'


def test_the_parts_are_there_alone(failure_of):
    error = failure_of('<launch>\n<node pkg="a"/></launch>')
    assert (error.edulaunch_file, error.edulaunch_line, error.edulaunch_tag) == ('robot.launch.xml', 2, 'node')
    assert str(error.edulaunch_origin) == 'robot.launch.xml:2'
