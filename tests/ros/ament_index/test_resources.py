"""ament_index_python.resources."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from ament_index_python import (
    InvalidResourceNameError,
    InvalidResourceTypeNameError,
    get_resource,
    get_resource_types,
    get_resources,
    get_search_paths,
    has_resource,
)

INDEX = 'share/ament_index/resource_index'


@pytest.fixture
def plugin(two_prefixes: tuple[str, str]) -> str:
    """A resource 'box' of the type 'plugin' in both prefixes."""
    for prefix, text in zip(two_prefixes, ('over', 'under'), strict=True):
        path = Path(prefix) / INDEX / 'plugin' / 'box'
        path.parent.mkdir()
        path.write_text(text, encoding='utf-8')
        (path.parent / '.hidden').write_text('', encoding='utf-8')
        (path.parents[1] / '.hidden').mkdir()
        (path.parents[1] / 'file').write_text('no type', encoding='utf-8')
    return two_prefixes[0]


def test_the_first_prefix_gives_the_resource(ask: Any, plugin: str) -> None:
    assert ask(lambda: get_resource('plugin', 'box')) == ('over', plugin)
    assert ask(lambda: has_resource('plugin', 'box')) == plugin
    assert ask(lambda: has_resource('plugin', 'bag')) is False
    assert ask(lambda: get_resources('plugin')) == {'box': plugin}
    assert ask(get_resource_types) == {'packages', 'plugin'}


@pytest.mark.parametrize(
    ('arguments', 'kind', 'text'),
    [
        (('plugin', 'bag'), LookupError, "Could not find the resource 'bag' of type 'plugin'"),
        (('a/b', 'bag'), InvalidResourceTypeNameError, "Resource type 'a/b' is invalid"),
        (('plugin', 'a\\b'), InvalidResourceNameError, "Resource name 'a\\b' is invalid"),
        (('', 'bag'), AssertionError, 'The resource type must not be empty'),
    ],
)
def test_errors_name_what_was_asked(ask: Any, arguments: tuple[str, str], kind: type, text: str) -> None:
    error = ask(lambda: get_resource(*arguments))
    assert (type(error), str(error)) == (kind, text)


def test_nothing_to_search_is_an_environment_error() -> None:
    from edulaunch.engine.packages import Index
    from tests.ros.ament_index.conftest import run_inside

    error = run_inside(Index(underlay=None), get_search_paths)
    assert (type(error), str(error)) == (OSError, "Environment variable 'AMENT_PREFIX_PATH' is not set or empty")
