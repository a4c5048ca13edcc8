"""A program that changes AMENT_PREFIX_PATH: exactly what it names is searched from then on. Answers of Jazzy's own package."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

import pytest
from ament_index_python import (
    PackageNotFoundError,
    get_package_prefix,
    get_package_share_path,
    get_packages_with_prefixes,
    get_resources,
    get_search_paths,
)

from edulaunch.engine.packages.sourced import sourced_path
from edulaunch.engine.processes import current_process
from edulaunch.engine.underlay_place import underlay_prefix


def with_path(value: str | None, body: Callable[[], Any]) -> Any:
    """What `body` gives in a program whose variable has another value."""

    def changed() -> Any:
        current_process().env.pop('AMENT_PREFIX_PATH', None)
        if value is not None:
            current_process().env['AMENT_PREFIX_PATH'] = value
        return body()

    return changed


def test_folders_that_are_there_in_the_given_order(ask: Any, two_prefixes: tuple[str, str]) -> None:
    over, under = two_prefixes
    assert ask(with_path(f'{under}:/no/such:{over}::{over}', get_search_paths)) == [under, over, over]
    assert ask(with_path(f'{under}:{over}', get_packages_with_prefixes)) == {'alpha': under, 'beta': over, 'gamma_robot': under}
    assert ask(with_path(over, lambda: get_resources('packages'))) == {'alpha': over, 'beta': over}


def test_only_they_are_searched(ask: Any, two_prefixes: tuple[str, str]) -> None:
    error = ask(with_path(two_prefixes[0], lambda: get_package_prefix('gamma_robot')))
    assert (type(error), error.args[0]) == (
        PackageNotFoundError,
        f"package 'gamma_robot' not found, searching: {[two_prefixes[0]]}",
    )


@pytest.mark.parametrize('body', [get_search_paths, get_packages_with_prefixes, lambda: get_package_prefix('turtlesim')])
def test_an_empty_variable_is_an_error(body: Callable[[], Any]) -> None:
    def emptied() -> list[str]:
        said = []
        for value in ('', None):
            try:
                with_path(value, body)()
            except OSError as error:
                said.append(str(error))
        return said

    before = os.environ.get('AMENT_PREFIX_PATH')
    try:
        assert emptied() == ["Environment variable 'AMENT_PREFIX_PATH' is not set or empty"] * 2
    finally:
        if before is not None:
            os.environ['AMENT_PREFIX_PATH'] = before


def test_folders_that_are_not_there_are_no_error(ask: Any) -> None:
    assert ask(with_path('/no/such', get_search_paths)) == []


def test_the_built_in_packages_stay_when_they_are_named(monkeypatch: pytest.MonkeyPatch, two_prefixes: tuple[str, str]) -> None:
    monkeypatch.setenv('AMENT_PREFIX_PATH', f'{two_prefixes[0]}:{os.environ["AMENT_PREFIX_PATH"]}')
    assert get_package_prefix('beta') == two_prefixes[0]
    assert get_package_prefix('turtlesim') == underlay_prefix()


def test_sourcing_puts_the_built_in_packages_on_the_variable() -> None:
    assert underlay_prefix() in sourced_path().split(os.pathsep)


def test_a_path_that_is_missing_is_called_a_path(ask: Any, two_prefixes: tuple[str, str]) -> None:
    os.rmdir(os.path.join(two_prefixes[0], 'share/alpha'))

    def body() -> str:
        with pytest.warns(UserWarning) as caught:
            get_package_share_path('alpha')
        return str(caught[0].message)

    assert ask(body) == f'Share path for alpha ({two_prefixes[0]}/share/alpha) does not exist.'
