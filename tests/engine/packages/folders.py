"""Workspaces written from a dict of files."""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from pathlib import Path

from edulaunch.engine.packages import Index
from edulaunch.ros.sources import read_source

PACKAGE_XML = '<package format="3"><name>{name}</name><export><build_type>{build}</build_type></export></package>\n'
SETUP_CFG = '[develop]\nscript_dir=$base/lib/{name}\n[install]\ninstall_scripts=$base/lib/{name}\n'

Build = Callable[..., Index]


class Workspace:
    """Writes files below `path` and makes indexes over them."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def write(self, **files: str) -> Workspace:
        """Texts by path; '__' in a keyword stands for '/', so use `files` for anything unusual."""
        return self.files({name.replace('__', '/'): text for name, text in files.items()})

    def files(self, files: dict[str, str]) -> Workspace:
        for name, text in files.items():
            path = self.path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(textwrap.dedent(text), encoding='utf-8')
        return self

    def python_package(self, name: str, setup: str, folder: str = '', **files: str) -> Workspace:
        """A package with package.xml, setup.cfg, a module folder, and the given setup.py."""
        base = folder or name
        self.files(
            {
                f'{base}/package.xml': PACKAGE_XML.format(name=name, build='ament_python'),
                f'{base}/setup.cfg': SETUP_CFG.format(name=name),
                f'{base}/resource/{name}': '',
                f'{base}/{name}/__init__.py': '',
                f'{base}/setup.py': setup,
            }
        )
        return self.files({f'{base}/{path.replace("__", "/")}': text for path, text in files.items()})

    def cmake_package(self, name: str, lists: str, files: dict[str, str] | None = None) -> Workspace:
        self.files({f'{name}/package.xml': PACKAGE_XML.format(name=name, build='ament_cmake'), f'{name}/CMakeLists.txt': lists})
        return self.files({f'{name}/{path}': text for path, text in (files or {}).items()})

    def index(self) -> Index:
        return Index(workspaces=[self.path], read_source=read_source, underlay=None)

    def installed(self, package: str) -> list[str]:
        """Paths below the share folder of a package."""
        index = self.index()  # its folder lives as long as it does
        share = index.share(package)
        assert share is not None
        return sorted(str(path.relative_to(share)) for path in Path(share).rglob('*') if path.is_file())

    def warnings(self, package: str) -> list[str]:
        """The warnings about one package, with paths shortened to the workspace."""
        index = self.index()
        index.executables(package)
        return [str(warning).replace(f'{self.path}/', '') for warning in index.warnings]
