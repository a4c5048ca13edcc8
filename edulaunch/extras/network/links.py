"""The available links by name."""

from __future__ import annotations

from importlib import import_module

from edulaunch.engine.nearest import did_you_mean
from edulaunch.errors import how_to_install
from edulaunch.extras.network.network_link import Link, LinkError

LINKS = {
    'cyclonedds': ('edulaunch.extras.network.dds.link', 'CycloneLink'),
    'rclpy': ('edulaunch.extras.network.rclpy_link', 'RclpyLink'),
}
DEFAULT = 'cyclonedds'
INSTALL = how_to_install('network')


def make_link(name: str = DEFAULT) -> Link:
    """Return a link that is not open yet.

    :raises LinkError: for an unknown name, or a missing dependency.
    """
    if name not in LINKS:
        raise LinkError(
            f'unknown link {name!r}: choose one of {", ".join(LINKS)}', help=did_you_mean(name, LINKS) or f'use {DEFAULT}'
        )
    module, class_name = LINKS[name]
    try:
        link: Link = getattr(import_module(module), class_name)()
    except ModuleNotFoundError as error:
        wanted = INSTALL if name == DEFAULT else 'edulaunch network install'
        raise LinkError(f'the link {name} needs {error.name}, which is not installed', help=wanted) from None
    return link
