"""`importlib.metadata` of a simulated program: its packages are distributions, as if the workspace were built."""

from __future__ import annotations

import importlib.metadata as real
import os
from collections.abc import Iterator
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names

if TYPE_CHECKING:
    from edulaunch.packages.reading import Contents
    from edulaunch.processes.process import Process


class PackageDistribution(real.Distribution):
    """Of a ROS package: its name, its version, and the entry points that its setup.py announces."""

    def __init__(self, process: Process, name: str, version: str, announced: dict[str, list[str]]) -> None:
        self._process = process
        self._texts = {
            'METADATA': f'Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n',
            'entry_points.txt': ''.join(f'[{group}]\n' + '\n'.join(lines) + '\n' for group, lines in announced.items()),
        }
        self._announced = announced

    def read_text(self, filename: str) -> str | None:
        """See `Distribution.read_text`."""
        return self._texts.get(filename)

    def locate_file(self, path: Any) -> Any:
        """See `Distribution.locate_file`."""
        return path

    @property
    def entry_points(self) -> Any:
        """All entry points; loading one imports what the program itself would import."""
        kind = _entry_point_kind(self._process)
        parts = [(group, *line.partition('=')[::2]) for group, lines in self._announced.items() for line in lines]
        return real.EntryPoints(
            kind(name=name.strip(), value=value.strip(), group=group)._for(self) for group, name, value in parts
        )


def _entry_point_kind(process: Process) -> Any:
    class PackageEntryPoint(real.EntryPoint):
        def load(self) -> Any:
            found: Any = process.loader.import_module(self.module)
            for name in filter(None, self.attr.split('.')):
                found = getattr(found, name)
            return found

    PackageEntryPoint.__name__ = PackageEntryPoint.__qualname__ = 'EntryPoint'
    return PackageEntryPoint


class Metadata:
    """The functions of the module, for one process."""

    def __init__(self, process: Process) -> None:
        self._process = process

    def distribution(self, distribution_name: str) -> real.Distribution:
        """The package of that name. Raises PackageNotFoundError."""
        package = distribution_name.replace('-', '_')
        file = os.path.join(self._process.index.share(package) or '', 'package.xml')
        if not os.path.isabs(file) or not os.path.isfile(file):
            return real.distribution(distribution_name)
        contents = self._process.index.contents(package)
        version = contents.version if contents is not None else ''
        if not version:
            from xml.etree import ElementTree

            version = (ElementTree.parse(file).findtext('version') or '0.0.0').strip()
        return PackageDistribution(self._process, distribution_name, version, contents.announced if contents is not None else {})

    def distributions(self, **options: Any) -> Iterator[real.Distribution]:
        """All packages of the workspaces, then everything that is installed here."""
        for package, _ in self._sources():
            yield self.distribution(package)
        yield from real.distributions(**options)

    def entry_points(self, **wanted: Any) -> Any:
        """The entry points of all packages that fit; those of the workspaces first."""
        own = real.EntryPoints(
            [
                point
                for package, contents in self._sources()
                if contents.announced
                for point in self.distribution(package).entry_points
            ]
        )
        installed: Any = real.entry_points(**wanted)
        if isinstance(installed, dict):  # up to Python 3.11, when nothing is wanted in particular
            points = [point for group in dict.values(installed) for point in group]
            return type(installed).load([*own, *points])  # type: ignore[attr-defined]
        return real.EntryPoints([*own.select(**wanted), *installed])

    def packages_distributions(self) -> dict[str, list[str]]:
        """Import name -> packages that have it."""
        found: dict[str, list[str]] = {}
        for package, contents in self._sources():
            for module in contents.python_modules:
                found.setdefault(module, []).append(package)
        return {**real.packages_distributions(), **found}

    def _sources(self) -> Iterator[tuple[str, Contents]]:
        index = self._process.index
        for package in index.packages():
            contents = index.contents(package)
            if contents is not None and (contents.python_modules or contents.announced):
                yield package, contents


def make(view: ModuleType, process: Process) -> ModuleType:
    """Names of the real module, over the packages of this program."""
    found = Metadata(process)
    view.__dict__.update(
        {name: getattr(found, name) for name in ('distribution', 'distributions', 'entry_points', 'packages_distributions')}
    )
    view.__dict__.update({name: _of_distribution(found, name) for name in ('metadata', 'version', 'files', 'requires')})
    copy_names(view, real)
    return view


def _of_distribution(found: Metadata, name: str) -> Any:
    return lambda distribution_name: getattr(found.distribution(distribution_name), name)
