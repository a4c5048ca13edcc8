"""Joining namespaces."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from launch_ros.utilities import is_namespace_absolute, make_namespace_absolute, prefix_namespace

NAMES = st.text('ab/', max_size=6) | st.none()


def test_prefixes_join_as_measured() -> None:
    pairs = [
        (None, None),
        (None, 'n'),
        ('b', None),
        ('b', 'n'),
        ('/b', 'n'),
        ('/b', '/n'),
        ('/', 'n'),
        ('', 'n'),
        ('b', ''),
        ('b/', 'n'),
        ('/b', 'n/'),
        (None, '/'),
        ('/b', '/'),
    ]
    assert [prefix_namespace(base, ns) for base, ns in pairs] == [
        None,
        'n',
        'b',
        'b/n',
        '/b/n',
        '/n',
        '/n',
        'n',
        'b',
        'b//n',
        '/b/n',
        '/',
        '/',
    ]


@given(NAMES, NAMES)
def test_an_absolute_namespace_ignores_what_was_pushed(base: str | None, ns: str | None) -> None:
    joined = prefix_namespace(base, ns)
    if ns is not None and is_namespace_absolute(ns):
        assert joined == prefix_namespace(None, ns)
    assert (make_namespace_absolute(joined) or '/').startswith('/')
