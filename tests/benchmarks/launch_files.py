"""How long launch needs to load and visit large launch files, in Python, XML and YAML.

Each file has N nodes with three parameters and two remappings. Measured is the CPU time of the real launch service in a
simulation, from its first step until the whole description has been visited: every command line is resolved, nothing is
started. Every round reads a text that was never read before, so nothing can have been kept of it. A *plan* goes on until
everything has started and ended. The bare work is what nobody can do without: to read the text (Python's compiler, expat,
libyaml) and to make one plain object with ten attributes for each node.
Python's compiler alone needs 44 of the milliseconds for 1000 nodes, grows by 5.5 to 6 from 1000 to 5000, and has its peak of
memory at 20 kB per node (0.6 kB stay): these two figures of Python are the compiler's, a file read before grows by 5.
The original launch needs 0.89 s for 1000 nodes in Python and 4.19 s in XML (../shared/reference, a machine like ours).
"""

from __future__ import annotations

import gc
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import edulaunch
from edulaunch.advice.plan import rehearse
from edulaunch.advice.plan.rehearsal import Notes, RehearsalHost
from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.runtime.session import index_for

ROUNDS = 7
FEW, MANY, DEPTH = 1000, 5000, 50
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
    return (
        'from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n'
        f'def generate_launch_description():\n    return LaunchDescription([\n{body}    ])\n'
    )


def xml_file(nodes: int) -> str:
    """An XML launch file."""
    return '<launch>\n' + ''.join(XML_NODE.format(i=i, r=i % 256) for i in range(nodes)) + '</launch>\n'


def yaml_file(nodes: int) -> str:
    """A YAML launch file."""
    return 'launch:\n' + ''.join(YAML_NODE.format(i=i, r=i % 256) for i in range(nodes))


def including_file(depth: int) -> str:
    """A Python launch file that includes the next one, `depth` deep."""
    below = (
        f"IncludeLaunchDescription(os.path.join(os.path.dirname(__file__), 'include_{depth - 1}.launch.py'), "
        f"launch_arguments={{'depth': '{depth}'}}.items())"
        if depth
        else "LogInfo(msg='the last one')"
    )
    return (
        'import os\n\nfrom launch import LaunchDescription\n'
        'from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, LogInfo\n\n\n'
        'def generate_launch_description():\n    return LaunchDescription([\n'
        f"        DeclareLaunchArgument('depth', default_value='0'),\n        {below}])\n"
    )


FORMATS: dict[str, tuple[str, Callable[[int], str]]] = {
    'Python': ('launch.py', python_file),
    'XML': ('launch.xml', xml_file),
    'YAML': ('launch.yaml', yaml_file),
}
COMMENTS = {'launch.py': '# {}\n', 'launch.xml': '<!-- {} -->\n', 'launch.yaml': '# {}\n'}


def visit_s(path: Path) -> float:
    """Seconds of CPU time to load the file and visit everything in it."""
    from launch import LaunchDescription, LaunchService
    from launch.actions import IncludeLaunchDescription, OpaqueFunction
    from launch.launch_description_sources import AnyLaunchDescriptionSource

    sim = Simulation()
    host = RehearsalHost(sim, Graph(sim, Notes()), index_for([]), env={})
    moments: list[float] = []

    def end(context: Any) -> None:
        moments.append(time.process_time())
        context.starts_are_abandoned = True
        sim.stop()

    def main(process: object) -> int:
        moments.append(time.process_time())
        service = LaunchService(noninteractive=True)
        include = IncludeLaunchDescription(AnyLaunchDescriptionSource(str(path)))
        service.include_launch_description(LaunchDescription([include, OpaqueFunction(function=end)]))
        return service.run()

    process = host.run_launch(main)
    sim.run()
    process.lifecycle.task.kill()
    sim.run()
    if len(moments) != 2:
        raise SystemExit(f'{path.name} was not visited to its end')
    return moments[1] - moments[0]


def plan_s(path: Path) -> float:
    """Seconds of CPU time to plan the file."""
    began = time.process_time()
    plan = rehearse(path, (), index_for([]), {}).plan
    if plan['error'] is not None:
        raise SystemExit(f'{path.name} cannot be planned: {plan["error"]["text"]}')
    return time.process_time() - began


def best_ms(measured_s: Callable[[Path], float], path: Path, rounds: int = ROUNDS) -> float:
    """The shortest of several; what else the machine does can only add time. The files of the folder change each time."""
    texts = {file: file.read_text(encoding='utf-8') for file in path.parent.iterdir()}
    gc.collect()
    times = []
    for number in range(rounds):
        for file, text in texts.items():
            file.write_text(text + COMMENTS[file.name.partition('.')[2]].format(number), encoding='utf-8')
        times.append(measured_s(path))
    return min(times) * 1e3


class Plain:
    """What stands for a node in the bare work."""

    def __init__(self, number: int) -> None:
        self.package, self.executable, self.name, self.namespace = 'turtlesim', 'turtlesim_node', f'{number}', f'/{number}'
        self.values, self.rules, self.words = {'r': number, 'g': 86}, [('pose', self.name)], ['-r', self.name]
        self.condition, self.environment, self.place = None, {}, (self.name, number)  # type: ignore[var-annotated]


def bare_ms(language: str, text: str) -> float:
    """Milliseconds of the bare work for :data:`FEW` nodes."""
    import yaml

    def read_xml() -> object:
        from pyexpat import ParserCreate

        expat, found = ParserCreate(), []  # type: ignore[var-annotated]
        expat.StartElementHandler = lambda tag, attributes: found.append((tag, attributes))
        return expat.Parse(text, True)

    read: dict[str, Callable[[], Any]] = {
        'Python': lambda: compile(text, '<bare>', 'exec'),
        'XML': read_xml,
        'YAML': lambda: yaml.load(text, Loader=getattr(yaml, 'CSafeLoader', yaml.SafeLoader)),
    }
    times = []
    for _ in range(ROUNDS):
        began = time.process_time()
        made = read[language](), [Plain(number) for number in range(FEW)]
        times.append(time.process_time() - began)
        del made
    return min(times) * 1e3


def kilobytes(path: Path, nodes: int) -> float:
    """Memory for each node when all have been visited, at the highest point."""
    import tracemalloc

    tracemalloc.start()
    try:
        visit_s(path)
        return tracemalloc.get_traced_memory()[1] / nodes / 1e3
    finally:
        tracemalloc.stop()


def _figures_of(language: str, folder: Path) -> dict[str, float]:
    suffix, make = FORMATS[language]
    figures: dict[str, float] = {}
    for nodes in (FEW, MANY):
        path = folder / f'{language}_{nodes}' / f'nodes.{suffix}'
        path.parent.mkdir()
        path.write_text(make(nodes), encoding='utf-8')
        figures[f'{nodes} nodes, {language} (ms)'] = best_ms(visit_s, path, ROUNDS if nodes == FEW else 3)
        if nodes == FEW:
            figures[f'plan of {nodes} nodes, {language} (ms)'] = best_ms(plan_s, path, 2)
            figures[f'memory of a node, {language} (kB)'] = kilobytes(path, nodes)
    few = figures[f'{FEW} nodes, {language} (ms)']
    figures[f'{MANY} nodes / {FEW} nodes, {language}'] = figures[f'{MANY} nodes, {language} (ms)'] / few
    figures[f'{FEW} nodes / bare work, {language}'] = few / bare_ms(language, make(FEW))
    return figures


def measure() -> dict[str, float]:
    """Milliseconds, kilobytes and ratios."""
    edulaunch.source()
    figures: dict[str, float] = {}
    with tempfile.TemporaryDirectory() as name:
        for language in FORMATS:
            figures.update(_figures_of(language, Path(name)))
        folder = Path(name) / 'includes'
        folder.mkdir()
        for depth in range(DEPTH + 1):
            (folder / f'include_{depth}.launch.py').write_text(including_file(depth), encoding='utf-8')
        deepest = folder / f'include_{DEPTH}.launch.py'
        figures[f'{DEPTH} nested includes (ms)'] = best_ms(visit_s, deepest)
        visit_s(deepest)
        figures[f'{DEPTH} nested includes, unchanged files (ms)'] = min(visit_s(deepest) for _ in range(ROUNDS)) * 1e3
    return figures


if __name__ == '__main__':
    for title, value in measure().items():
        print(f'{title:<44} {value:>9.2f}')
