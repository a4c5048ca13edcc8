"""Create a package with its package.xml, and print the output of `ros2 pkg create`."""

from __future__ import annotations

import os
import re
from collections.abc import Callable

from edulaunch.advice.workspace.package_files import LICENSES, NewPackage, license_notice, write_cmake, write_python
from edulaunch.errors import PackageError

BUILD_TYPES = ('ament_cmake', 'ament_python')
LINTERS = {
    'ament_cmake': ('ament_lint_auto', 'ament_lint_common'),
    'ament_python': ('ament_copyright', 'ament_flake8', 'ament_pep257', 'python3-pytest'),
}
_NAME = re.compile(r'[a-z][a-z0-9_]*')


def create_package(package: NewPackage, say: Callable[[str], object]) -> None:
    """Create the files of a package.

    :param package: the properties of the package.
    :param say: a function that is called with each line of the output.
    :raises PackageError: when the name is invalid, the build type is unknown, or the folder already exists.
    """
    _refuse(package)
    for line in _summary(package):
        say(line)
    writer = _Writer(package, say)
    writer.folder('.')
    writer.file('package.xml', manifest_text(package))
    (write_python if package.build_type == 'ament_python' else write_cmake)(package, writer)
    notice = license_notice(package.license, package.maintainer_name)
    if notice is not None:
        writer.quiet('LICENSE', notice)
    else:
        say(
            f"\n[WARNING]: Unknown license '{package.license}'.  "
            'This has been set in the package.xml, but no LICENSE file has been created.\n'
            'It is recommended to use one of the ament license identifiers:\n' + '\n'.join(LICENSES)
        )


def _refuse(package: NewPackage) -> None:
    if package.build_type not in BUILD_TYPES:
        raise PackageError(f'unknown build type {package.build_type!r}.', help=f'use {" or ".join(BUILD_TYPES)}')
    if not _NAME.fullmatch(package.name) or package.name.endswith('_') or '__' in package.name:
        raise PackageError(
            f'{package.name!r} cannot be the name of a package.',
            help='use lowercase letters, digits and single underscores, and start with a letter',
        )
    if package.build_type == 'ament_python' and package.name == package.node_name:
        raise PackageError(
            'the node of a Python package cannot have the name of the package.',
            help=f'name the node something else, such as {package.name}_node',
        )
    if os.path.exists(package.folder):
        raise PackageError(
            f'\nAborted!\nThe directory already exists: {package.folder}\n'
            'Either remove the directory or choose a different destination directory or package name'
        )
    if not os.path.isdir(package.destination):
        raise PackageError(
            f'the folder {package.destination!r} does not exist.',
            help='make it first, or name another one with --destination-directory',
        )


def _summary(package: NewPackage) -> list[str]:
    lines = [
        'going to create a new package',
        f'package name: {package.name}',
        f'destination directory: {os.path.abspath(package.destination)}',
        'package format: 3',
        'version: 0.0.0',
        f'description: {package.description}',
        f"maintainer: ['{package.maintainer_name} <{package.maintainer_email}>']",
        f'licenses: {[package.license]}',
        f'build type: {package.build_type}',
        f'dependencies: {list(package.dependencies)}',
    ]
    lines += [f'node_name: {package.node_name}'] if package.node_name else []
    return lines + ([f'library_name: {package.library_name}'] if package.library_name else [])


class _Writer:
    """Writes files below the folder of the package, and reports each file."""

    def __init__(self, package: NewPackage, say: Callable[[str], object]) -> None:
        self.say = say
        self._folder = package.folder
        self._shown = os.path.join(os.curdir, package.name) if package.destination == os.curdir else package.folder

    def folder(self, name: str) -> None:
        """Report a folder, and create it."""
        self.say(f'creating folder {os.path.join(self._shown, name).removesuffix("/.")}')
        os.makedirs(os.path.join(self._folder, name), exist_ok=True)

    def file(self, name: str, text: str) -> None:
        """Report a file, and write it."""
        self.say(f'creating {os.path.join(self._shown, name)}')
        self.quiet(name, text)

    def quiet(self, name: str, text: str) -> None:
        """Write a file without reporting it."""
        with open(os.path.join(self._folder, name), 'w', encoding='utf-8', newline='\n') as file:
            file.write(text)


def manifest_text(package: NewPackage) -> str:
    """Return the content of the package.xml of a package."""
    from xml.sax.saxutils import escape, quoteattr

    tool = [] if package.build_type == 'ament_python' else [f'<buildtool_depend>{package.build_type}</buildtool_depend>']
    groups = [
        tool,
        [f'<depend>{escape(name)}</depend>' for name in package.dependencies],
        [f'<test_depend>{name}</test_depend>' for name in LINTERS[package.build_type]],
    ]
    lines = [
        '<?xml version="1.0"?>',
        '<?xml-model href="http://download.ros.org/schema/package_format3.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>',
        '<package format="3">',
        f'  <name>{package.name}</name>',
        '  <version>0.0.0</version>',
        f'  <description>{escape(package.description)}</description>',
        f'  <maintainer email={quoteattr(package.maintainer_email)}>{escape(package.maintainer_name)}</maintainer>',
        f'  <license>{escape(package.license)}</license>',
    ]
    for group in groups:
        lines += ['', *(f'  {line}' for line in group)] if group else []
    lines += ['', '  <export>', f'    <build_type>{package.build_type}</build_type>', '  </export>', '</package>']
    return '\n'.join(lines) + '\n'
