"""What a setup.py installs, read without running it."""

from __future__ import annotations

from typing import Any

import pytest

HEAD = """
import os
from glob import glob
from setuptools import find_packages, setup
package_name = 'robo'
"""
LAUNCH = {
    'robo/launch/a.launch.py': '',
    'robo/launch/b_launch.py': '',
    'robo/launch/c.launch.xml': '',
    'robo/config/deep/p.yaml': '',
    'robo/robo/sub/deep.py': '',
}


def setup_with(**keywords: str) -> str:
    return (
        HEAD
        + 'setup(name=package_name, packages=[package_name], '
        + ', '.join(f'{name}={text}' for name, text in keywords.items())
        + ')\n'
    )


@pytest.mark.parametrize(
    'entry',
    [
        "('share/' + package_name + '/launch', glob('launch/*.launch.py'))",
        "(os.path.join('share', package_name, 'launch'), glob(os.path.join('launch', '*.launch.py')))",
        "(f'share/{package_name}/launch', ['launch/a.launch.py'])",
        "('share/%s/launch' % package_name, [x for x in glob('launch/*') if x.endswith('.launch.py')])",
        "('share/{}/launch'.format(package_name), ['launch/' + name for name in ('a.launch.py',)])",
        "(os.path.join('share', package_name, 'launch'), glob('launch/*launch.[p]y')[:1])",
    ],
)
def test_common_spellings_of_data_files_install_the_launch_file(workspace: Any, entry: str) -> None:
    workspace.python_package('robo', setup_with(data_files=f'[{entry}]')).files(LAUNCH)
    assert workspace.installed('robo') == ['launch/a.launch.py', 'package.xml']
    assert workspace.warnings('robo') == []


@pytest.mark.parametrize(
    'setup',
    [
        # a list that grows
        HEAD + "data = [('share/' + package_name, ['package.xml'])]\n"
        "data.append(('share/robo/launch', glob('launch/*.xml')))\nsetup(name='robo', data_files=data)",
        HEAD + ("data = []\ndata += [('share/robo/launch', glob('launch/*.xml'))]\nsetup(name='robo', data_files=data)"),
        # a function of the file's own
        HEAD + 'def files(folder):\n    found = []\n    for path, _, names in os.walk(folder):\n'
        "        for name in names:\n            if name.endswith('.xml'):\n"
        "                found.append(('share/robo/' + path, [os.path.join(path, name)]))\n    return found\n"
        "setup(name='robo', data_files=[*files('launch')])",
        HEAD + ("options = dict(data_files=[('share/robo/launch', ['launch/c.launch.xml'])])\nsetup(name='robo', **options)"),
        (
            'import setuptools, pathlib\nhere = pathlib.Path("launch")\n'
            'setuptools.setup(data_files=[("share/robo/launch", [str(here / "c.launch.xml")])])'
        ),
        (
            'from pathlib import Path\nfrom setuptools import setup\n'
            'setup(data_files=[("share/robo/launch", [str(x) for x in Path("launch").glob("*.xml")])])'
        ),
        (
            'from pathlib import Path\nfrom setuptools import setup\nhere = Path(__file__).resolve().parent\n'
            'setup(data_files=[("share/robo/launch", list(map(str, (here / "launch").rglob("c.*"))))])'
        ),
        # any number of folders, below them whatever is a file
        'from pathlib import Path\nfrom setuptools import setup\nname = Path(__file__).parent.name\n'
        'def tree(*folders, end, **more):\n    out = []\n    for folder in folders:\n'
        "        for f in sorted(Path(folder).rglob('*')):\n            if f.is_file() and f.suffix == end:\n"
        "                out.append((str(Path('share') / name / f.parent), [str(f)]))\n    return out\n"
        "setup(name=name, data_files=[*tree('launch', 'config', end='.xml', verbose=True)])",
        # lambdas
        HEAD
        + "xml = lambda folder: list(filter(lambda f: f.endswith('xml'), map(lambda f: folder + '/' + f, os.listdir(folder))))\n"
        "setup(name='robo', data_files=[('share/robo/launch', xml('launch'))])",
    ],
)
def test_lists_made_by_a_program_are_followed(workspace: Any, setup: str) -> None:
    workspace.python_package('robo', setup).files(LAUNCH)
    assert workspace.installed('robo') == ['launch/c.launch.xml', 'package.xml']


def test_nothing_of_the_file_is_executed(workspace: Any) -> None:
    workspace.python_package('robo', "open('ran', 'w')\nraise SystemExit\nsetup()\n")
    workspace.index().share('robo')
    assert not (workspace.path / 'robo' / 'ran').exists()


def test_what_cannot_be_known_costs_only_its_own_entry_and_names_the_line(workspace: Any) -> None:
    entries = "[('share/robo/launch', glob('launch/*.xml')),\n  ('share/robo/config', shared.download('x')),\n]"
    workspace.python_package('robo', 'import shared\n' + setup_with(data_files=entries)).files(LAUNCH)
    assert workspace.installed('robo') == ['launch/c.launch.xml', 'package.xml']
    assert workspace.warnings('robo') == [
        (
            "robo/setup.py:8: data_files= contains shared.download('x'), which edulaunch cannot compute without running "
            'the file; '
            'write the value itself'
        )
    ]


@pytest.mark.parametrize(
    'entry_points',
    [
        "{'console_scripts': ['talk = robo.talker:main']}",
        "'''[console_scripts]\ntalk=robo.talker:main\n'''",
        "{'console_scripts': 'talk = robo.talker : main'}",
        "dict(console_scripts=['talk' + ' = ' + package_name + '.talker:main'])",
    ],
)
def test_console_scripts_become_entry_points(workspace: Any, entry_points: str) -> None:
    workspace.python_package('robo', setup_with(entry_points=entry_points))
    index = workspace.index()
    program = index.find_program(f'{index.prefix("robo")}/lib/robo/talk')
    assert (program.kind, program.module, program.function) == ('entry_point', 'robo.talker', 'main')
    assert program.python_roots == (str(workspace.path / 'robo'),)


def test_without_install_scripts_the_executable_is_not_found_and_a_warning_says_why(workspace: Any) -> None:
    workspace.python_package('robo', setup_with(entry_points="{'console_scripts': ['talk = robo.talker:main']}"))
    workspace.files({'robo/setup.cfg': '[develop]\nscript_dir=$base/lib/robo\n'})
    assert workspace.index().executables('robo') == []
    assert workspace.warnings('robo') == [
        (
            'robo/setup.cfg: has no install_scripts=$base/lib/robo in its section [install], so `ros2 run robo ...` '
            'and Node() '
            'find no executable of this package'
        )
    ]


@pytest.mark.parametrize(
    ('keywords', 'sentence'),
    [
        (
            {'data_files': "[('share/robo/launch', ['launch/none.py'])]"},
            ("data_files lists 'launch/none.py', which is not there (a build stops with \"can't copy 'launch/none.py'\")"),
        ),
        (
            {'data_files': "[('share/robo', ['launch'])]"},
            (
                "data_files lists 'launch', which is a folder; only files can be listed, so use glob() "
                "(a build stops with \"can't copy 'launch'\")"
            ),
        ),
        ({'data_files': "['share/robo']"}, "data_files contains 'share/robo'; a pair (folder, [files]) was expected"),
        (
            {'entry_points': "{'console_scripts': ['talk = robo/talker:main']}"},
            "console_scripts has 'talk = robo/talker:main'; 'executable = package.module:function' was expected",
        ),
        ({'py_modules': '[]', 'scripts': "['bin/x']"}, "scripts= lists 'bin/x', which is not there"),
        (
            {'data_files': "[('/share/robo', ['launch/a.launch.py'])]"},
            "data_files names the absolute folder '/share/robo', outside the workspace; remove the first /",
        ),
        (
            {'entry_points': "{'console_scripts': ['deep = robo.sub.deep:main']}"},
            "installs 'deep' of the console_scripts, but not robo/sub/ with its module (except with --symlink-install); "
            "add 'robo.sub' to packages=, or create an __init__.py there for find_packages()",
        ),
    ],
)
def test_what_a_build_would_reject_is_a_warning_with_its_line(workspace: Any, keywords: dict[str, str], sentence: str) -> None:
    workspace.python_package('robo', setup_with(**keywords)).files(LAUNCH)
    assert workspace.warnings('robo') == [f'robo/setup.py:6: {sentence}']


@pytest.mark.parametrize(
    'entry', ['robo = my-robot.hello:main', 'robo = robo.hello:', 'robo = robo.hello:main()', 'robo robo:main']
)
def test_an_entry_point_that_setuptools_refuses_stops_the_build(workspace: Any, entry: str) -> None:
    workspace.python_package('robo', setup_with(entry_points=f"{{'console_scripts': ['{entry}']}}"))
    index = workspace.index()
    assert index.executables('robo') == []
    place = index.workspaces[0]
    broken = place.contents('robo').broken
    assert broken is not None and broken.sentence.startswith(f"console_scripts has '{entry}'")


def test_a_build_type_that_colcon_does_not_know_is_named(workspace: Any) -> None:
    workspace.python_package('robo', setup_with())
    manifest = workspace.path / 'robo' / 'package.xml'
    manifest.write_text(manifest.read_text().replace('ament_python', 'ament_pyton'))
    assert workspace.warnings('robo') == [
        "robo/package.xml: names the build type 'ament_pyton', which colcon cannot build; write ament_python or ament_cmake"
    ]


def test_a_package_folder_that_is_missing_is_named(workspace: Any) -> None:
    workspace.python_package('robo', "from setuptools import setup\nsetup(packages=['rob'])\n")
    assert workspace.warnings('robo') == [
        (
            "robo/setup.py:2: packages= names 'rob', but there is no folder rob/ "
            '(a build stops with "package directory \'rob\' does not exist")'
        )
    ]


def test_a_syntax_error_is_a_warning_and_the_package_is_still_found(workspace: Any) -> None:
    workspace.python_package('robo', 'setup(\n  name=\n')
    assert workspace.installed('robo') == ['package.xml']
    assert workspace.warnings('robo')[0].startswith('robo/setup.py:')


def test_find_packages_looks_for_init_files_and_package_dir_moves_the_root(workspace: Any) -> None:
    setup = HEAD + "setup(packages=find_packages('src', exclude=['test']), package_dir={'': 'src'})\n"
    workspace.python_package('robo', setup).files(
        {
            'robo/src/robo_lib/__init__.py': '',
            'robo/src/robo_lib/inner/__init__.py': '',
            'robo/src/test/__init__.py': '',
            'robo/src/plain/x.py': '',
        }
    )
    assert workspace.index().python_modules() == {'robo_lib': str(workspace.path / 'robo' / 'src' / 'robo_lib')}


def test_an_endless_loop_is_not_followed_for_ever(workspace: Any) -> None:
    loop = 'names = list(range(9))\nfor a in names:\n  names.append(a)\n'
    workspace.python_package('robo', HEAD + loop + "setup(name='robo', packages=['robo'])\n")
    workspace.index().executables('robo')


@pytest.mark.parametrize('start', [b'\xef\xbb\xbf', '# -*- coding: latin-1 -*-\n# gr\xfcn\n'.encode('latin-1')])
def test_encodings_that_python_reads_are_read(workspace: Any, start: bytes) -> None:
    workspace.python_package('robo', '')
    text = b"from setuptools import setup\r\nsetup(entry_points={'gui_scripts': ['go = robo.go:main']})\r\n"
    (workspace.path / 'robo' / 'setup.py').write_bytes(start + text)
    (workspace.path / 'robo' / 'setup.cfg').write_bytes(b'\xef\xbb\xbf[install]\r\ninstall-scripts=$base/lib/robo\r\n')
    assert workspace.index().executables('robo') == ['go'] and workspace.warnings('robo') == []


BARE = 'from setuptools import setup\nsetup()\n'
IN_SETUP_CFG = """\
[metadata]
name = robo
[options]
packages = find:
[options.data_files]
share/ament_index/resource_index/packages = resource/robo
share/robo/launch =
    launch/*.launch.py
[options.entry_points]
console_scripts =
    Talker = robo.talker:main
[install]
install_scripts = $base/lib/robo
"""
IN_PYPROJECT = """\
[project]
name = 'robo'
[project.scripts]
Talker = 'robo.talker:main'
[tool.setuptools]
packages = ['robo']
[tool.setuptools.data-files]
'share/robo/launch' = ['launch/*.launch.py']
"""


@pytest.mark.parametrize('texts', [{'setup.cfg': IN_SETUP_CFG}, {'pyproject.toml': IN_PYPROJECT}])
def test_tables_of_setup_cfg_and_pyproject_count_as_arguments_of_setup(workspace: Any, texts: dict[str, str]) -> None:
    if 'pyproject.toml' in texts:
        pytest.importorskip('tomllib')
    workspace.python_package('robo', BARE).files({'robo/launch/a.launch.py': '', 'robo/robo/talker.py': ''})
    workspace.files({f'robo/{name}': text for name, text in texts.items()})
    assert workspace.warnings('robo') == []
    assert workspace.installed('robo') == ['launch/a.launch.py', 'package.xml']
    assert workspace.index().executables('robo') == ['Talker']


def test_a_mistake_in_setup_cfg_is_told_there_and_setup_stands_above_it(workspace: Any) -> None:
    wrong = IN_SETUP_CFG.replace('launch/*.launch.py', 'launch/b.launch.py').replace('find:', 'robot')
    workspace.python_package('robo', setup_with()).files({'robo/setup.cfg': wrong})
    assert workspace.warnings('robo') == [
        "robo/setup.cfg: data_files lists 'launch/b.launch.py', which is not there "
        "(a build stops with \"can't copy 'launch/b.launch.py'\")"
    ]


def test_a_package_without_setup_py_is_reported(workspace: Any) -> None:
    workspace.python_package('robo', BARE).files({'robo/setup.cfg': IN_SETUP_CFG})
    (workspace.path / 'robo' / 'setup.py').unlink()
    assert 'is missing, so this ament_python package cannot be built' in workspace.warnings('robo')[0]


UNDEFINED = (
    HEAD
    + """setup(
    packages=['robo'],
    data_files=[({expression}, ['package.xml'])],
)
"""
)


@pytest.mark.parametrize(
    ('expression', 'name', 'rest'),
    [
        ("oss.path.join('share', 'robo')", 'oss', ''),
        ("json.loads('1')", 'json', '; write import json at the top'),
        ("'share/' + package_nam", 'package_nam', ''),
        ("[f'{x}{y}' for x in nothing]", 'nothing', ''),
    ],
)
def test_a_name_that_nobody_defines_stops_the_build_and_is_told_as_python_does(
    workspace: Any, expression: str, name: str, rest: str
) -> None:
    setup = UNDEFINED.format(expression=expression)
    workspace.python_package('robo', setup)
    line = next(number for number, text in enumerate(setup.splitlines(), 1) if expression in text)
    assert workspace.warnings('robo') == [
        f"robo/setup.py:{line}: a build stops with NameError: name '{name}' is not defined{rest}"
    ]
    assert workspace.installed('robo') == ['package.xml']


@pytest.mark.parametrize(
    'before',
    [
        'from os.path import *\n',
        'if True:\n    nothing = []\n',
        'try:\n    nothing\nexcept NameError:\n    nothing = []\n',
        "exec('nothing = []')\n",
        'for nothing in ([],):\n    pass\n',
        'nothing = [] or also_nothing\n',
        'def later():\n    return never_called\nnothing = []\n',
        'nothing = [(lambda: later), *(two if False else ()) or two] if False else []\n',
    ],
)
def test_names_that_may_be_defined_are_left_alone(workspace: Any, before: str) -> None:
    workspace.python_package('robo', HEAD + before + "setup(packages=['robo'], data_files=[('share/robo', nothing)])\n")
    assert not [line for line in workspace.warnings('robo') if 'NameError' in line]
