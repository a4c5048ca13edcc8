"""`edulaunch.explain`: the object, its HTML, its words."""

from __future__ import annotations

import shutil
from html.parser import HTMLParser
from pathlib import Path

import pytest

import edulaunch
from edulaunch.errors import UnusableInput

XML = """<launch>
  <arg name="green" default="86"/>
  <group><push-ros-namespace namespace="left"/>
    <node pkg="turtlesim" exec="turtlesim_node" name="sim">
      <param from="{folder}/p.yaml"/>
      <param name="background_g" value="$(var green)"/>
      <param name="title" value="&lt;script&gt;"/>
    </node>
  </group>
  <include file="{folder}/more.launch.yaml"><arg name="green" value="$(var green)"/></include>
</launch>
"""
YAML = """launch:
- arg: {name: green, default: '1'}
- node: {pkg: demo_nodes_cpp, exec: talker, name: talker, param: [{name: rate, value: $(var green)}], if: $(eval "1 > 2")}
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / 'my.launch.xml'
    path.write_text(XML.format(folder=tmp_path))
    (tmp_path / 'more.launch.yaml').write_text(YAML)
    (tmp_path / 'p.yaml').write_text('/**:\n  ros__parameters:\n    background_g: 1\n    background_r: 2\n')
    return path


def test_xml_and_yaml_files_are_explained_with_places(file: Path) -> None:
    lines = str(edulaunch.explain(file, arguments={'green': 5})).replace(str(file.parent), '').splitlines()
    assert lines == [
        '/my.launch.xml',
        "├── argument green = '5'  (command line, instead of '86')  <my.launch.xml:2>",
        '├── group  <my.launch.xml:3>',
        '│   ├── namespace /left  <my.launch.xml:3>',
        '│   └── node /left/sim: turtlesim turtlesim_node  <my.launch.xml:4>',
        '│       ├── parameter background_g = 5  (launch argument green, instead of 1 from p.yaml line 3)',
        '│       ├── parameter background_r = 2  (p.yaml line 4)',
        "│       └── parameter title = '<script>'  (my.launch.xml line 7)",
        '└── include /more.launch.yaml  <my.launch.xml:10>',
        "    ├── argument green = '5'  (include in my.launch.xml line 10, instead of '1')  <more.launch.yaml:2>",
        "    └── Node 'talker'  [if PythonExpr('1 > 2', ['math']): not taken]  <more.launch.yaml:3>",
    ]


def test_the_chain_goes_through_includes(file: Path) -> None:
    reason = edulaunch.explain(file, arguments={'green': 5}).why('left/sim', 'background_g')
    assert [(step['value'], step['origin'], step['line'], step['counts']) for step in reason.data[0]['steps']] == [
        (86, 'declared by turtlesim_node', None, False),
        (1, 'p.yaml line 3', 3, False),
        (5, 'launch argument green', 6, True),
    ]
    argument = reason.data[0]['steps'][-1]['argument']
    assert [(step['value'], step['origin']) for step in argument] == [('86', 'default'), ('5', 'command line')]


class Balance(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: set[str] = set()

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.open.append(tag)
        self.tags.add(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_an_include_from_a_workspace_is_named_as_the_student_wrote_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copytree(Path(__file__).resolve().parents[3] / 'solutions' / 'convoy', tmp_path / 'src' / 'convoy')
    monkeypatch.chdir(tmp_path)
    lines = str(edulaunch.explain('convoy', 'convoy.launch.py')).splitlines()
    included = [line.strip('│├└─ ').split('  ')[0] for line in lines if '─ include ' in line]
    assert included == ['include src/convoy/launch/follower.launch.py']


def test_a_notebook_gets_a_tree_that_opens_without_script_and_with_nothing_of_the_file_as_html(file: Path) -> None:
    page = edulaunch.explain(file)._repr_html_()
    parser = Balance()
    parser.feed(page)
    assert not parser.open and parser.tags == {'style', 'div', 'b', 'details', 'summary', 'span', 'small'}
    assert page.count('<details open>') == 3 and '&lt;script&gt;' in page and 'aria-label="explanation of ' in page


def test_a_large_tree_shows_its_nodes_closed(tmp_path: Path) -> None:
    path = tmp_path / 'many.launch.xml'
    node = '<node pkg="turtlesim" exec="turtlesim_node" name="n{}"><remap from="a" to="b"/></node>'
    path.write_text('<launch>' + ''.join(map(node.format, range(40))) + '</launch>')
    assert edulaunch.explain(path)._repr_html_().count('<details>') == 40


def test_an_error_is_told_below_what_was_visited(tmp_path: Path) -> None:
    path = tmp_path / 'wrong.launch.xml'
    path.write_text('<launch><log message="a"/><node pkg="turtlsim" exec="turtlesim_node"/></launch>')
    explanation = edulaunch.explain(path)
    assert '[launch stopped here]' in str(explanation) and "error: \"package 'turtlsim' not found" in str(explanation)
    assert 'error:' in explanation._repr_html_() and explanation.alt == str(explanation)


def test_a_missing_file_is_unusable_input(tmp_path: Path) -> None:
    (tmp_path / 'my.launch.py').write_text('')
    with pytest.raises(UnusableInput, match=r'does not exist'):
        edulaunch.explain(tmp_path / 'mi.launch.py')


def test_two_explanations_are_compared_with_their_arguments_as_title(file: Path) -> None:
    before = edulaunch.explain(file)
    after = edulaunch.explain(file, arguments={'green': 5})
    assert before.compare(after).title == 'my.launch.xml  ->  my.launch.xml green:=5'
    assert before.compare(before).title == 'my.launch.xml  ->  my.launch.xml\nno difference'
