"""`importlib.metadata` sees packages of a source workspace as if they were built."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch
from edulaunch.processes.spec import ProcessSpec

SETUP = """\
from setuptools import setup
setup(name='robo', version='2.5.0', packages=['robo'], entry_points={
    'console_scripts': ['talk = robo.talk:main'],
    'robo.plugins': ['fast = robo.plugins:Fast.make', 'slow = robo.plugins:slow'],
})
"""
FILES = {
    'package.xml': '<package><name>robo</name><version>1.0.0</version><export><build_type>ament_python</build_type></export></package>',
    'setup.py': SETUP,
    'setup.cfg': '[install]\ninstall_scripts=$base/lib/robo\n',
    'robo/__init__.py': '',
    'robo/talk.py': 'def main():\n    pass\n',
    'robo/plugins.py': 'class Fast:\n    @staticmethod\n    def make():\n        return "vroom"\ndef slow():\n    return "..."\n',
}


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    for name, text in FILES.items():
        file = tmp_path / 'ws' / 'robo' / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return tmp_path / 'ws'


def said(workspace: Path, text: str) -> str:
    script = workspace.parent / 'asks.py'
    script.write_text(text)
    written: list[str] = []
    with edulaunch.Session(workspaces=[workspace]) as session:
        spec = ProcessSpec(argv=('python3', str(script)), name='asks-1')
        session.host.start(spec, on_output=lambda stream, text: written.append(text), on_exit=lambda code: None)
        session.run(5)
    return ''.join(written)


def test_plugins_are_found_and_loaded_by_their_group(workspace: Path) -> None:
    assert (
        said(
            workspace,
            """
from importlib.metadata import entry_points
for point in entry_points(group='robo.plugins'):
    print(point.name, point.value, point.dist.name, point.load()())
print([point.value for point in entry_points().select(group='console_scripts', name='talk')])
""",
        )
        == "fast robo.plugins:Fast.make robo vroom\nslow robo.plugins:slow robo ...\n['robo.talk:main']\n"
    )


def test_a_distribution_has_the_version_of_setup_and_its_entry_points(workspace: Path) -> None:
    assert (
        said(
            workspace,
            """
from importlib import metadata
robo = metadata.distribution('robo')
print(robo.version, metadata.version('robo'), metadata.metadata('robo')['Name'], metadata.requires('robo'))
print(sorted(point.name for point in robo.entry_points), metadata.packages_distributions()['robo'])
print(next(iter(metadata.distributions())).metadata['Name'])
try:
    metadata.version('robby')
except metadata.PackageNotFoundError as error:
    print(error)
""",
        )
        == "2.5.0 2.5.0 robo None\n['fast', 'slow', 'talk'] ['robo']\nrobo\nNo package metadata was found for robby\n"
    )


def test_the_manifest_has_the_version_that_setup_does_not_say(workspace: Path) -> None:
    (workspace / 'robo' / 'setup.py').write_text(SETUP.replace("version='2.5.0', ", ''))
    assert said(workspace, "from importlib.metadata import version; print(version('robo'))") == '1.0.0\n'


@pytest.mark.parametrize(
    'file, text',
    [
        ('setup.cfg', '[metadata]\nversion = 3.1\n[options.entry_points]\nrobo.plugins =\n    slow = robo.plugins:slow\n'),
        ('pyproject.toml', '[project]\nversion = "3.1"\n[project.entry-points."robo.plugins"]\nslow = "robo.plugins:slow"\n'),
    ],
)
def test_tables_announce_entry_points_too(workspace: Path, file: str, text: str) -> None:
    if file == 'pyproject.toml':
        pytest.importorskip('tomllib')
    (workspace / 'robo' / 'setup.py').write_text("from setuptools import setup\nsetup(packages=['robo'])\n")
    (workspace / 'robo' / file).write_text(text)
    assert (
        said(
            workspace,
            """
from importlib.metadata import entry_points, version
print(version('robo'), [point.load()() for point in entry_points(group='robo.plugins')])
""",
        )
        == "3.1 ['...']\n"
    )
