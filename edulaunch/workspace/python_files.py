"""The files of a new ament_python package."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.workspace.new_package import NewPackage

SETUP = """\
from setuptools import find_packages, setup

package_name = {name!r}

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer={maintainer_name!r},
    maintainer_email={maintainer_email!r},
    description={description!r},
    license={license!r},
    tests_require=['pytest'],
    entry_points={{
        'console_scripts': [
{scripts}        ],
    }},
)
"""
CONFIGURATION = """\
[develop]
script_dir=$base/lib/{name}
[install]
install_scripts=$base/lib/{name}
[tool:pytest]
markers =
    copyright: checks the copyright notices
    flake8: checks the style of the code
    pep257: checks the docstrings
    linter: checks how the code is written
"""
NODE = """\
def main():
    print('Hi from {name}.')


if __name__ == '__main__':
    main()
"""
LINTER = """\
import pytest


@pytest.mark.{mark}
@pytest.mark.linter
def test_{mark}():
    tool = pytest.importorskip('ament_{mark}.main')
    assert tool.{call} == 0, '{complaint}'
"""
LINTERS = {
    'copyright': ("main(argv=['.', 'test'])", 'a file has no copyright notice'),
    'flake8': ('main(argv=[])', 'the code style differs'),
    'pep257': ("main(argv=['.', 'test'])", 'a docstring is missing or of another form'),
}


def write(package: NewPackage, writer: Any) -> None:
    """Write them, in the order of `ros2 pkg create`."""
    name = package.name
    entry = f"            '{package.node_name} = {name}.{package.node_name}:main',\n" if package.node_name else ''
    writer.say('creating source folder')
    writer.folder(name)
    writer.file(
        'setup.py',
        SETUP.format(
            name=name,
            maintainer_name=package.maintainer_name,
            maintainer_email=package.maintainer_email,
            description=package.description,
            license=package.license,
            scripts=entry,
        ),
    )
    writer.file('setup.cfg', CONFIGURATION.format(name=name))
    writer.folder('resource')
    writer.file(f'resource/{name}', '')
    writer.file(f'{name}/__init__.py', '')
    writer.folder('test')
    for mark, (call, complaint) in LINTERS.items():
        writer.file(f'test/test_{mark}.py', LINTER.format(mark=mark, call=call, complaint=complaint))
    if package.library_name:
        writer.folder(f'{name}/{package.library_name}')
        writer.file(f'{name}/{package.library_name}/__init__.py', '')
    if package.node_name:
        writer.file(f'{name}/{package.node_name}.py', NODE.format(name=name))
