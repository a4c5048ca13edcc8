"""The launch files on which simulation and reality are compared, each as the words of `edulaunch compare`."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterable, Sequence
from pathlib import Path

from edulaunch.engine.packages.discovery import workspaces_of_command
from edulaunch.engine.underlay_place import underlay_prefix
from edulaunch.errors import EdulaunchError
from edulaunch.extras.comparing.sweep import launch_files
from edulaunch.runtime.session import Session
from tests.lessons.notebook import ORDER, Lesson
from tests.packages_corpus.cases import CASES, CORPUS

REPOSITORY = Path(__file__).resolve().parents[3]
SEEDS = REPOSITORY.parent / 'shared' / 'seeds' / 'files'
A, B, C = 'examples_rclpy_minimal_', 'demo_nodes_', 'action_tutorials_'
DEMOS: dict[str, tuple[str, ...]] = {
    'fibonacci_py': (C + 'py fibonacci_action_server', C + 'py fibonacci_action_client'),
    'fibonacci_cpp': (C + 'cpp fibonacci_action_server', C + 'cpp fibonacci_action_client'),
    'add_two_ints': (B + 'py add_two_ints_server', B + 'py add_two_ints_client'),
    'add_two_ints_async': (B + 'py add_two_ints_server', B + 'py add_two_ints_client_async'),
    'talker': (B + 'py talker', B + 'py listener'),
    'talker_qos': (B + 'py talker_qos', B + 'py listener_qos'),
    'talker_serialized': (B + 'py talker', B + 'py listener_serialized'),
    'matched': (B + 'cpp matched_event_detect',),
    'blackboard': (B + 'cpp parameter_blackboard', B + 'py async_param_client'),
    'parameters_callback': (B + 'py set_parameters_callback',),
    'logger_service': (B + 'py use_logger_service',),
    'introspection': (B + 'cpp introspection_service', B + 'cpp introspection_client'),
    'set_and_get': (B + 'cpp set_and_get_parameters',),
    'list_parameters': (B + 'cpp list_parameters',),
    'timers': (B + 'cpp one_off_timer', B + 'cpp reuse_timer'),
    'callback_group': ('examples_rclpy_executors callback_group',),
    'composed': ('examples_rclpy_executors composed',),
    'custom_callback_group': ('examples_rclpy_executors custom_callback_group',),
    'custom_executor': ('examples_rclpy_executors custom_executor',),
    'executors_talker': ('examples_rclpy_executors talker', 'examples_rclpy_executors listener'),
    'guard': ('examples_rclpy_guard_conditions trigger_guard_condition',),
    **{
        f'action_{name}': (A + 'action_server server', A + f'action_client {name}')
        for name in ('client', 'client_asyncio', 'client_cancel', 'client_not_composable')
    },
    **{
        f'action_{name}': (A + f'action_server {name}', A + 'action_client client')
        for name in ('server_defer', 'server_not_composable', 'server_queue_goals', 'server_single_goal')
    },
    **{
        f'service_{name}': (A + 'service service', A + f'client {name}')
        for name in ('client', 'client_async', 'client_async_callback', 'client_async_member_function')
    },
    'service_member_function': (A + 'service service_member_function', A + 'client client'),
    **{f'publisher_{name}': (A + f'publisher publisher_{name}',) for name in ('local_function', 'member_function', 'old_school')},
    **{
        f'subscriber_{name}': (A + 'publisher publisher_member_function', A + f'subscriber subscriber_{name}')
        for name in ('lambda', 'member_function', 'old_school')
    },
    'point_cloud': ('examples_rclpy_pointcloud_publisher pointcloud_publisher',),
    'lifecycle': ('lifecycle lifecycle_talker', 'lifecycle lifecycle_listener', 'lifecycle lifecycle_service_client'),
    'lifecycle_py': ('lifecycle_py lifecycle_talker', 'lifecycle lifecycle_service_client'),
    'logging': ('logging_demo logging_demo_main',),
    'composition': ('composition manual_composition',),
    'square': ('turtlesim turtlesim_node', 'turtlesim draw_square'),
    'mimic': ('turtlesim turtlesim_node', 'turtlesim mimic'),
    'buffer_server': ('tf2_ros buffer_server',),
    'monitor': ('tf2_ros tf2_monitor',),
    'waffle': ('turtlebot3_gazebo waffle_simulator',),
    'frames': ('turtle_tf2_py dynamic_frame_tf2_broadcaster', 'turtle_tf2_py fixed_frame_tf2_broadcaster'),
}
"""Demos that come without a launch file: the programs that belong together."""
Items = list[tuple[str, ...]]


def _launchable(paths: Iterable[str]) -> Items:
    """Those that can be launched as they are: without the parts of others that need arguments, and without mistakes made on purpose."""
    return [(path,) for path in paths if _begins(path)]


def _begins(path: str) -> bool:
    with Session(workspaces=workspaces_of_command((), path)) as session:
        try:
            launch = session.launch(path)
            session.run(0.0)
            launch.raise_error()
        except EdulaunchError:
            return False
    return True


def solutions() -> Items:
    """Our solutions of the exercises."""
    return _launchable(launch_files(str(REPOSITORY / 'solutions')))


def demos(folder: Path) -> Items:
    """One launch file for each of :data:`DEMOS`, and those of the built-in packages."""
    for name, programs in DEMOS.items():
        nodes = ''.join('  <node pkg="{}" exec="{}"/>\n'.format(*program.split()) for program in programs)
        (folder / f'{name}.launch.xml').write_text(f'<launch>\n{nodes}</launch>\n')
    built_in = launch_files(str(Path(underlay_prefix()) / 'share'))
    return _launchable([*(str(folder / f'{name}.launch.xml') for name in DEMOS), *built_in])


def corpus() -> Items:
    """The packages of students, as the tests of the corpus launch them; without those that are typed to."""
    return [
        (*_launch(CORPUS / folder, case.file), *(f'{name}:={value}' for name, value in case.arguments.items()))
        for folder, case in CASES.items()
        if not case.stdin
    ]


def _launch(folder: Path, file: str) -> tuple[str, ...]:
    return (str(next(path for path in sorted(folder.rglob(file)) if not {'build', 'install'} & set(path.parts))),)


def lessons(folder: Path) -> Items:
    """What the lessons write, a folder for each lesson: of a file that is written several times the last text."""
    for name in ORDER:
        for place, text in Lesson(name).files().items():
            path = folder / name / place
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
    return _launchable(launch_files(str(folder)))


def folder_of(words: Sequence[str]) -> str | None:
    """Where a student stands: what a lesson writes is launched from the folder of the lesson."""
    for part in ('/my_launch/', '/my_ws/'):
        before, found, _ = words[0].partition(part)
        if found:
            return before
    return None


def seeds(folder: Path) -> Items:
    """The tutorials that this project began with, where they are at hand."""
    if not SEEDS.is_dir():
        return []
    shutil.copytree(SEEDS, folder, dirs_exist_ok=True)
    rows = json.loads((SEEDS / 'index.json').read_text())
    return _launchable(str(folder / row['file']) for row in rows if row['kind'] == 'python_launch')
