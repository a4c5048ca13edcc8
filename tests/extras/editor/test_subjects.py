"""What the cursor is on, in finished and unfinished files."""

from __future__ import annotations

import pytest

from edulaunch.advice.texts import Text
from edulaunch.extras.editor.subjects import Subject, subject_at


@pytest.mark.parametrize(
    ('name', 'text', 'kind', 'whole', 'owner'),
    [
        ('a.launch.py', "Node(package='turt|", 'package', 'turt', ''),
        ('a.launch.py', "Node(package='a', executable='b|c')", 'executable', 'bc', 'a'),
        ('a.launch.py', "Node(executable='b|', package='a')", 'executable', 'b', 'a'),
        ('a.launch.py', "Node(package='a', executable='b', parameters=[{'x': 1, 'y|'", 'parameter', 'y', 'a/b'),
        ('a.launch.py', "Node(package='a', executable='b', remappings=[('c', 'd'), ('e|'", 'topic', 'e', 'a/b'),
        ('a.launch.py', "LaunchConfiguration('w|ho')", 'argument', 'who', ''),
        ('a.launch.py', "get_package_share_directory('x|')", 'package', 'x', ''),
        ('a.launch.py', "FindPackageShare('p'), 'launch', 'f|.launch.py'", 'launch file', 'f.launch.py', 'p'),
        ('a.py', "self.create_publisher(Twist, 'c|md'", 'topic', 'cmd', ''),
        ('a.py', "lookup_transform('a', 'b|'", 'frame', 'b', ''),
        ('a.py', 'from std_msgs.msg import A, S|', 'interface', 'S', 'std_msgs.msg'),
        ('a.launch.py', 'Node(name="x", pac|', 'keyword', 'pac', 'Node'),
        ('a.launch.xml', '<node pkg="a" exec="b|c"', 'executable', 'bc', 'a'),
        ('a.launch.xml', '<node pkg="a" exec="b"/><log message="$(var w|ho)"', 'argument', 'who', ''),
        ('a.launch.xml', '<include file="$(find-pkg-share p)/launch/f|"', 'launch file', 'f', 'p'),
        ('a.launch.xml', '<gro|', 'element', 'gro', ''),
        ('a.launch.yaml', 'launch:\n- node:\n    pkg: tur|', 'package', 'tur', ''),
        ('a.launch.yaml', 'launch:\n- no|', 'element', 'no', ''),
    ],
)  # fmt: skip
def test_it_is_known_by_what_is_in_front(name: str, text: str, kind: str, whole: str, owner: str) -> None:
    offset = text.index('|')
    found = subject_at(Text(text.replace('|', ''), f'/w/{name}'), offset)
    assert isinstance(found, Subject) and (found.kind, found.name, found.owner) == (kind, whole, owner)


@pytest.mark.parametrize('text', ["print('|')", '# Node(package=|', 'x = |'])
def test_anything_else_is_none(text: str) -> None:
    assert subject_at(Text(text.replace('|', ''), '/w/a.launch.py'), text.index('|')) is None
