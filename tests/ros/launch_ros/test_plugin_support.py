"""Which versions a caret range accepts."""

from __future__ import annotations

import pytest
from launch_ros.utilities.plugin_support import PLUGIN_SYSTEM_VERSION, PluginException, satisfies_version


@pytest.mark.parametrize(
    ('version', 'wanted', 'problem'),
    [
        ('0.1', '^0.1', ''),
        ('0.1.5', '^0.1', ''),
        ('0.2', '^0.1', 'newer'),
        ('0.0.9', '^0.1', 'too old'),
        ('1.9', '^1.2', ''),
        ('1.2', '^1.2', ''),
        ('1.1', '^1.2', 'too old'),
        ('2.0', '^1.2', 'newer'),
        ('0.0.3', '^0.0.3', ''),
        ('0.0.4', '^0.0.3', 'newer'),
        ('0.0', '^0.0', ''),
        ('0.1', '^0.0', 'newer'),
    ],
)
def test_a_caret_range(version: str, wanted: str, problem: str) -> None:
    if problem:
        with pytest.raises(PluginException, match=problem):
            satisfies_version(version, wanted)
    else:
        satisfies_version(version, wanted)


def test_another_range_is_refused() -> None:
    with pytest.raises(ValueError, match="'0.1' is no caret range"):
        satisfies_version('0.1', '0.1')


def test_extensions_for_jazzy_fit_the_extension_points() -> None:
    satisfies_version(PLUGIN_SYSTEM_VERSION, '^0.1')
    with pytest.raises(PluginException, match=r"Extension point is too old \('0.1'\), the extension requires '\^0.2'"):
        satisfies_version(PLUGIN_SYSTEM_VERSION, '^0.2')
