"""How long launch needs to load and visit large launch files, in Python, XML and YAML.

Each file has N nodes with three parameters and two remappings. Measured is the real launch service in a simulation, from
its first step until the whole description has been visited: every command line is resolved, nothing is started.
The original launch needs 0.89 s for 1000 nodes in Python and 4.19 s in XML (../shared/reference, a machine like ours).
"""
from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import edulaunch
from edulaunch.graph.graph import Graph
from edulaunch.plan.rehearsal import Notes, RehearsalHost
from edulaunch.session import index_for
from edulaunch.sim.simulation import Simulation

ROUNDS = 5
PYTHON_NODE = """        Node(package='turtlesim', executable='turtlesim_node', name='sim_{i}', namespace='robot_{i}',
             parameters=[{{'background_r': {r}, 'background_g': 86, 'label': 'robot {i}'}}],
             remappings=[('pose', 'where_{i}'), ('cmd_vel', 'drive_{i}')]),
"""
XML_NODE = """  <node pkg="turtlesim" exec="turtlesim_node" name="sim_{i}" namespace="robot_{i}">
    <param name="background_r" value="{r}"/>
    <param name="background_g" value="86"/>
    <param name="label" value="robot {i}"/>
    <remap from="pose" to="where_{i}"/>
    <remap from="cmd_vel" to="drive_{i}"/>
  </node>
"""
YAML_NODE = """- node:
    pkg: turtlesim
    exec: turtlesim_node
    name: sim_{i}
    namespace: robot_{i}
    param:
    - {{name: background_r, value: {r}}}
    - {{name: background_g, value: 86}}
    - {{name: label, value: robot {i}}}
    remap:
    - {{from: pose, to: where_{i}}}
    - {{from: cmd_vel, to: drive_{i}}}
"""


def python_file(nodes: int) -> str:
    """A Python launch file."""
    body = ''.join(PYTHON_NODE.format(i=i, r=i % 256) for i in range(nodes))
    return ('from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n'
            f'def generate_launch_description():\n    return LaunchDescription([\n{body}    ])\n')


def xml_file(nodes: int) -> str:
    """An XML launch file."""
    return '<launch>\n' + ''.join(XML_NODE.format(i=i, r=i % 256) for i in range(nodes)) + '</launch>\n'


def yaml_file(nodes: int) -> str:
    """A YAML launch file."""
    return 'launch:\n' + ''.join(YAML_NODE.format(i=i, r=i % 256) for i in range(nodes))


def including_file(depth: int) -> str:
    """A Python launch file that includes the next one, `depth` deep."""
    below = (f"IncludeLaunchDescription(os.path.join(os.path.dirname(__file__), 'include_{depth - 1}.launch.py'), "
             f"launch_arguments={{'depth': '{depth}'}}.items())" if depth else "LogInfo(msg='the last one')")
    return ('import os\n\nfrom launch import LaunchDescription\n'
            'from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, LogInfo\n\n\n'
            'def generate_launch_description():\n    return LaunchDescription([\n'
            f"        DeclareLaunchArgument('depth', default_value='0'),\n        {below}])\n")


FORMATS: dict[str, tuple[str, Callable[[int], str]]] = {
    'Python': ('launch.py', python_file), 'XML': ('launch.xml', xml_file), 'YAML': ('launch.yaml', yaml_file)}


def visit_s(path: Path) -> float:
    """Seconds of real time to load the file and visit everything in it."""
    from launch import LaunchDescription, LaunchService
    from launch.actions import IncludeLaunchDescription, OpaqueFunction
    from launch.launch_description_sources import AnyLaunchDescriptionSource
    sim = Simulation()
    host = RehearsalHost(sim, Graph(sim, Notes()), index_for([]), env={})
    moments: list[float] = []

    def end(context: object) -> None:
        moments.append(time.process_time())
        sim.stop()

    def main(process: object) -> int:
        moments.append(time.process_time())
        service = LaunchService(noninteractive=True)
        include = IncludeLaunchDescription(AnyLaunchDescriptionSource(str(path)))
        service.include_launch_description(LaunchDescription([include, OpaqueFunction(function=end)]))
        return service.run()

    process = host.run_launch(main)
    sim.run()
    process.task.kill()
    sim.run()
    if len(moments) != 2:
        raise SystemExit(f'{path.name} was not visited to its end')
    return moments[1] - moments[0]


def best_s(path: Path, rounds: int = ROUNDS) -> float:
    """The shortest of several; what else the machine does can only add time."""
    return min(visit_s(path) for _ in range(rounds))


def measure() -> dict[str, float]:
    """Milliseconds."""
    edulaunch.source()
    figures = {}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for nodes in (1000, 5000):
            for language, (suffix, make) in FORMATS.items():
                path = folder / f'nodes_{nodes}.{suffix}'
                path.write_text(make(nodes), encoding='utf-8')
                figures[f'{nodes} nodes, {language} (ms)'] = best_s(path, ROUNDS if nodes == 1000 else 3) * 1e3
        for depth in range(51):
            (folder / f'include_{depth}.launch.py').write_text(including_file(depth), encoding='utf-8')
        figures['50 nested includes (ms)'] = best_s(folder / 'include_50.launch.py') * 1e3
    for language in FORMATS:
        figures[f'5000 nodes / 1000 nodes, {language}'] = (
            figures[f'5000 nodes, {language} (ms)'] / figures[f'1000 nodes, {language} (ms)'])
    return figures


if __name__ == '__main__':
    for title, value in measure().items():
        print(f'{title:<36} {value:>9.2f}')
