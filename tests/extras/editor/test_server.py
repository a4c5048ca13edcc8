"""The language server, over its protocol: a beginner's session, and each thing that an editor asks for."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import edulaunch
from tests.extras.editor.client import Editor, editor

pytestmark = pytest.mark.processes
pytest.importorskip('pygls', reason="pygls is not installed: pip install 'edulaunch[editor]'")

LINES = [
    'from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\ndef generate_launch_description():\n    return LaunchDescription([\n',
    "        Node(package='turtlesim', executable='turtlesim_nod'),\n",
    "        Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name='b1', parameters=[{'turtlename': 'turtle1'}]),\n",
    "        Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', nmae='b2', parameters=[{'turtlename': 'turtle2'}]),\n",
    "        Node(package='turtle_tf2_py', executable='turtle_tf2_listener', parameters=[{'target_frame': 'turtle1'}])\n",
    "        Node(package='turtlesim', executable='draw_square'),\n    ])\n",
]
"""What the beginner types, with three mistakes: an executable, a keyword, and a comma that is missing."""


def test_a_beginner_writes_a_follower_and_is_shown_three_mistakes_while_typing(tmp_path: Path) -> None:
    path = tmp_path / 'follow.launch.py'
    with editor(tmp_path) as session:
        assert session.open(path, '') == []
        text, seen = '', []
        for line in LINES:
            text += line
            closed = text if text.endswith('])\n') else text + '    ])\n' if text.count('[') > text.count(']') else text
            seen.append([(one['code'], one['message'].splitlines()[-1]) for one in session.type(path, closed)])
        assert seen[1] == [('packages.no-executable', "write 'turtlesim_node'")]
        assert ('launch.keyword', 'write name=') in seen[3]
        assert [code for code, _ in seen[5]] == ['programs.no-comma']
        text = session.fixed(path, session.diagnostics[path.as_uri()][0])
        for code in ('launch.keyword', 'packages.no-executable'):
            found = session.type(path, text)
            text = session.fixed(path, next(one for one in found if one['code'] == code))
        assert session.type(path, text) == [] == session.save(path)
    recording = edulaunch.run(path, duration_s=60)
    assert [(process.name, process.returncode) for process in recording.processes if process.returncode not in (None, -2)] == []
    poses = [message for _, message in recording.messages('/turtle2/pose')]
    assert max(math.hypot(pose.x - poses[0].x, pose.y - poses[0].y) for pose in poses) > 1.0


@pytest.fixture(scope='module')
def session(tmp_path_factory: pytest.TempPathFactory):  # type: ignore[no-untyped-def]
    folder = tmp_path_factory.mktemp('editor')
    with editor(folder) as found:
        found.folder = folder
        yield found


@pytest.fixture
def path(session: Editor) -> Path:
    found: Path = session.folder / 'a.launch.py'  # type: ignore[attr-defined]
    session.open(found, '')
    return found


def test_what_the_server_says_that_it_can_do(session: Editor) -> None:
    can = session.about['capabilities']
    assert {name for name in can if name.endswith('Provider')} >= {
        *('codeActionProvider', 'completionProvider', 'definitionProvider', 'hoverProvider', 'referencesProvider')
    }


@pytest.mark.parametrize(
    ('text', 'label', 'detail'),
    [
        ("Node(package='|')", 'turtlesim', 'built-in package'),
        ("Node(package='turtlesim', executable='tur|')", 'turtlesim_node', 'executable of turtlesim'),
        ("Node(package='turtlesim', executable='turtlesim_node', parameters=[{'|'}])", 'background_r', 'default: 69'),
        ("Node(package='turtlesim', executable='turtlesim_node', remappings=[('|')])", 'turtle1/cmd_vel', 'geometry_msgs/msg/Twist'),
        ("DeclareLaunchArgument('who', default_value='me')\nLaunchConfiguration('|')", 'who', 'default: me'),
        ("generate_launch_description\nPathJoinSubstitution([FindPackageShare('turtlesim'), 'launch', '|'])", 'multisim.launch.py', 'in launch/multisim.launch.py'),
        ('import rclpy\nfrom geometry_msgs.msg import |', 'Twist', 'geometry_msgs.msg'),
        ('import rclpy\nfrom geo|', 'geometry_msgs.msg', None),
        ("import rclpy\nt.child_frame_id = 'carrot1'\nbuffer.lookup_transform('|')", 'carrot1', 'frame'),
        ('Node(pack|)', 'package=', 'argument of Node'),
    ],
)  # fmt: skip
def test_completion(session: Editor, path: Path, text: str, label: str, detail: str | None) -> None:
    items = session.at('completion', path, text)
    found = next(item for item in items if item['label'] == label)
    assert found.get('detail') == detail and found['textEdit']['newText'] == label


def test_completion_replaces_the_whole_name(session: Editor, path: Path) -> None:
    (item, *_) = session.at('completion', path, "Node(package='tur|tlesm')")
    assert item['textEdit']['range'] == {'start': {'line': 0, 'character': 14}, 'end': {'line': 0, 'character': 22}}


@pytest.mark.parametrize(
    ('text', 'shown'),
    [
        ("Node(package='turtlesim', executable='turtle|sim_node')", 'parameter `background_r`, default `69`'),
        ("DeclareLaunchArgument('who', default_value='me')\nLaunchConfiguration('w|ho')", '- default `me`, line 1'),
        ('import rclpy\nfrom geometry_msgs.msg import Tw|ist', 'Vector3 linear'),
        ("Node(package='turt|lesim')", 'executables: `draw_square`'),
    ],
)  # fmt: skip
def test_hover(session: Editor, path: Path, text: str, shown: str) -> None:
    assert shown in session.at('hover', path, text)['contents']['value']


def test_hover_shows_the_value_and_its_origin_after_saving(session: Editor, path: Path) -> None:
    text = (
        'from launch import LaunchDescription\nfrom launch.actions import DeclareLaunchArgument, LogInfo\n'
        'from launch.substitutions import LaunchConfiguration\n\n\ndef generate_launch_description():\n    return LaunchDescription([\n'
        "        DeclareLaunchArgument('who', default_value=['a', 'b']),\n        LogInfo(msg=LaunchConfiguration('wh|o')),\n    ])\n"
    )
    session.type(path, text.replace('|', ''))
    session.save(path)
    assert '**`ab`** from default (a.launch.py:8)' in session.at('hover', path, text)['contents']['value']


def test_definitions_and_all_uses_of_an_argument(session: Editor, path: Path) -> None:
    own = "import rclpy\nDeclareLaunchArgument('who')\nLaunchConfiguration('who')\nLaunchConfiguration('w|ho')\n"
    other = session.folder / 'outer.launch.py'  # type: ignore[attr-defined]
    other.write_text("include('a.launch.py', launch_arguments={'who': 'x'}.items())\n", encoding='utf-8')
    place = session.at('definition', path, own)
    assert (place['uri'], place['range']['start']) == (path.as_uri(), {'line': 1, 'character': 23})
    found = session.at('references', path, own, context={'includeDeclaration': True})
    assert [(one['uri'], one['range']['start']['line']) for one in found] == [
        *((path.as_uri(), line) for line in (1, 2, 3)),
        (other.as_uri(), 0),
    ]
    place = session.at('definition', path, "FindPackageShare('turtlesim'), 'launch', 'multi|sim.launch.py'\n# LaunchDescription")
    assert place['uri'].endswith('/turtlesim/launch/multisim.launch.py')


def test_what_only_a_dry_run_finds_comes_with_saving(session: Editor, path: Path) -> None:
    text = (
        'from launch import LaunchDescription\nfrom launch.actions import LogInfo\n\n\ndef generate_launch_description():\n'
        '    words = [1, 2]\n    return LaunchDescription([LogInfo(msg=str(words[5]))])\n'
    )
    assert session.type(path, text) == []
    (found,) = session.save(path)
    assert (found['code'], found['range']['start']['line']) == ('launch.fails', 6)
    assert session.type(path, text.replace('[5]', '[1]')) == []


def test_a_cell_that_writes_a_launch_file_keeps_its_lines(session: Editor) -> None:
    path: Path = session.folder / 'nb.ipynb.python-1(launch-python).launch.py'  # type: ignore[attr-defined]
    (found,) = session.open(path, '%%writefile my.launch.py\nfrom launch import LaunchDescripton\n')[:1]
    assert (found['code'], found['range']['start']) == ('launch.import-name', {'line': 1, 'character': 19})


def test_no_run_executes_nothing(tmp_path: Path) -> None:
    path = tmp_path / 'a.launch.py'
    text = 'from launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription([1 / 0])\n'
    with editor(tmp_path, '--no-run') as quiet:
        quiet.open(path, text)
        assert quiet.save(path) == []
