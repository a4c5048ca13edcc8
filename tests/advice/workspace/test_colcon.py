"""What the real colcon builds is found, and behaves as the sources do."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import edulaunch
from edulaunch.advice.workspace.new_package import create_package
from edulaunch.advice.workspace.package_files import NewPackage
from edulaunch.engine.packages import Index
from edulaunch.ros.sources import read_source
from edulaunch.runtime.session import index_for

SEEDS = Path(__file__).resolve().parents[4] / 'shared' / 'seeds' / 'files'
PACKAGES = ('large_projects/launch_tutorial', 'tf2_book/learning_tf2_py')
COLCON = shutil.which('colcon', path=os.pathsep.join([os.path.dirname(sys.executable), os.environ.get('PATH', '')]))
pytestmark = pytest.mark.skipif(COLCON is None, reason="colcon is not installed (pip install '.[workspace]')")


def build(folder: Path) -> None:
    environment = dict(os.environ, PATH=os.pathsep.join([os.path.dirname(COLCON or ''), os.environ.get('PATH', '')]))
    environment.pop('PYTHONPATH', None)
    done = subprocess.run(
        [str(COLCON), '--log-base', str(folder / 'log'), 'build'],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.fixture(scope='module')
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    if not SEEDS.is_dir():
        pytest.skip('the seed tutorials are not beside this repository')
    folder = tmp_path_factory.mktemp('colcon')
    for package in PACKAGES:
        shutil.copytree(SEEDS / package, folder / 'src' / package.rpartition('/')[2], copy_function=shutil.copy)
    create_package(NewPackage('my_package', str(folder / 'src'), 'ament_python', node_name='my_node'), lambda line: None)
    build(folder)
    return folder


@pytest.mark.processes
@pytest.mark.parametrize(
    ('package', 'file'), [('launch_tutorial', 'launch_turtlesim.launch.py'), ('learning_tf2_py', 'turtle_tf2_demo.launch.py')]
)
def test_built_and_from_source_the_recordings_are_equal(built: Path, package: str, file: str) -> None:
    source, installed = (edulaunch.run(package, file, duration_s=5, workspaces=[folder]) for folder in (built, built / 'install'))
    assert len(source.nodes) > 3 and source.digest() == installed.digest()


@pytest.mark.processes
def test_a_package_made_here_builds_and_runs(built: Path, tmp_path: Path) -> None:
    index = index_for([built / 'install'])
    assert index.executables('my_package') == ['my_node']
    assert index.prefix('my_package') == str(built / 'install' / 'my_package')
    assert Index([], [built], read_source=read_source).executables('my_package') == ['my_node']
