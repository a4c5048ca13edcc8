"""`pkg_resources` of a simulated program: files, versions and entry points of its own packages, with or without setuptools."""

from __future__ import annotations

import io
import os
from collections.abc import Iterator
from importlib import metadata
from types import ModuleType
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


class DistributionNotFound(Exception):
    """A package that is not installed was asked for."""

    def __init__(self, req: str) -> None:
        super().__init__(req, None)
        self.req = req

    def __str__(self) -> str:
        return f"The '{self.req}' distribution was not found and is required by the application"


class Distribution(NamedTuple):
    """An installed package."""

    project_name: str
    version: str

    def __str__(self) -> str:
        return f'{self.project_name} {self.version}'


class Resources:
    """The functions about files; a package is named, or given as a module."""

    def __init__(self, process: Process) -> None:
        self._process = process

    def resource_filename(self, package_or_requirement: Any, resource_name: str) -> str:
        """Where a file of a package lies."""
        module: Any = self._process.loader.import_module(getattr(package_or_requirement, '__name__', str(package_or_requirement)))
        file = getattr(module, '__file__', None)
        folder = os.path.dirname(file) if file else next(iter(module.__path__))
        return os.path.join(folder, *filter(None, resource_name.split('/')))

    def resource_string(self, package_or_requirement: Any, resource_name: str) -> bytes:
        """The bytes of a file. Raises FileNotFoundError."""
        with open(self.resource_filename(package_or_requirement, resource_name), 'rb') as file:
            return file.read()

    def resource_stream(self, package_or_requirement: Any, resource_name: str) -> io.BytesIO:
        """A file, to be read."""
        return io.BytesIO(self.resource_string(package_or_requirement, resource_name))

    def resource_exists(self, package_or_requirement: Any, resource_name: str) -> bool:
        """Whether there is such a file or folder."""
        return os.path.exists(self.resource_filename(package_or_requirement, resource_name))

    def resource_isdir(self, package_or_requirement: Any, resource_name: str) -> bool:
        """Whether it is a folder."""
        return os.path.isdir(self.resource_filename(package_or_requirement, resource_name))

    def resource_listdir(self, package_or_requirement: Any, resource_name: str) -> list[str]:
        """The names in a folder, in the order of the alphabet."""
        return sorted(os.listdir(self.resource_filename(package_or_requirement, resource_name)))


def make(view: ModuleType, process: Process) -> ModuleType:
    """What nodes use of it: resources, `get_distribution`, `require`, `iter_entry_points` and `load_entry_point`."""
    own_metadata: Any = process.loader.import_module('importlib.metadata')

    def get_distribution(dist: Any) -> Distribution:
        name = getattr(dist, 'project_name', str(dist))
        try:
            return Distribution(name, own_metadata.version(name))
        except metadata.PackageNotFoundError:
            raise DistributionNotFound(name) from None

    def require(*requirements: Any) -> list[Distribution]:
        return [get_distribution(requirement) for requirement in requirements]

    def iter_entry_points(group: str, name: str | None = None) -> Iterator[metadata.EntryPoint]:
        wanted = {'group': group} if name is None else {'group': group, 'name': name}
        yield from own_metadata.entry_points(**wanted)

    def load_entry_point(dist: str, group: str, name: str) -> Any:
        for entry_point in own_metadata.distribution(dist).entry_points.select(group=group, name=name):
            return entry_point.load()
        raise ImportError(f'Entry point {(group, name)!r} not found')

    resources = Resources(process)
    view.__dict__.update({name: getattr(resources, name) for name in dir(resources) if name.startswith('resource_')})
    view.__dict__.update(
        Distribution=Distribution,
        DistributionNotFound=DistributionNotFound,
        get_distribution=get_distribution,
        require=require,
        iter_entry_points=iter_entry_points,
        load_entry_point=load_entry_point,
    )
    return view
