"""Messages about packages that only an extra of edulaunch installs."""

from __future__ import annotations

import re
import sys

from edulaunch.errors import MissingExtra, how_to_install
from tests.house import ROOT, modules

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

EXTRAS = tomllib.loads((ROOT / 'pyproject.toml').read_text('utf-8'))['project']['optional-dependencies']


def test_the_message_names_the_package_and_the_line_that_installs_it() -> None:
    error = MissingExtra('ros2 bag', 'rosbags', 'bags')
    assert (
        str(error)
        == "ros2 bag needs rosbags, which is not installed\n  help: run this in the folder of edulaunch's setup.sh: pip install '.[bags]'"
    )


def test_every_extra_that_a_message_names_is_there() -> None:
    calls = re.compile(r"(?:MissingExtra\([^()]*?, |how_to_install\()'(\w+)'\)")
    named = {extra for path in modules().values() for extra in calls.findall(path.read_text('utf-8'))}
    assert {'bags', 'urdf', 'notebook', 'network', 'dask', 'sign'} <= named <= set(EXTRAS)
    assert how_to_install('bags').endswith("pip install '.[bags]'")


def test_no_message_names_a_package_index_that_does_not_have_edulaunch() -> None:
    """Where a name is assumed, the help says so."""
    assumed = re.compile(r"pip install (--\S+ )?['\"]?edulaunch\b")
    texts = {path.name: path.read_text('utf-8') for path in modules().values()}
    wrong = [name for name, text in texts.items() if assumed.search(text) and 'not on PyPI yet' not in text]
    assert wrong == []


def test_the_notebook_set_brings_what_the_lessons_use() -> None:
    assert 'edulaunch[bags,urdf]' in EXTRAS['notebook']
