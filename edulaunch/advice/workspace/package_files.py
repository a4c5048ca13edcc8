"""Write the files of a new Python or CMake package, including the text of its license."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

SETUP = """\
from setuptools import find_packages, setup

package_name = {name!r}

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer={maintainer_name!r},
    maintainer_email={maintainer_email!r},
    description={description!r},
    license={license!r},
    tests_require=['pytest'],
    entry_points={{
        'console_scripts': [
{scripts}        ],
    }},
)
"""
CONFIGURATION = """\
[develop]
script_dir=$base/lib/{name}
[install]
install_scripts=$base/lib/{name}
[tool:pytest]
markers =
    copyright: checks the copyright notices
    flake8: checks the style of the code
    pep257: checks the docstrings
    linter: checks how the code is written
"""
PYTHON_NODE = """\
def main():
    print('Hi from {name}.')


if __name__ == '__main__':
    main()
"""
LINTER = """\
import pytest


@pytest.mark.{mark}
@pytest.mark.linter
def test_{mark}():
    tool = pytest.importorskip('ament_{mark}.main')
    assert tool.{call} == 0, '{complaint}'
"""
LINTERS = {
    'copyright': ("main(argv=['.', 'test'])", 'a file has no copyright notice'),
    'flake8': ('main(argv=[])', 'the code style differs'),
    'pep257': ("main(argv=['.', 'test'])", 'a docstring is missing or of another form'),
}


@dataclass(frozen=True)
class NewPackage:
    """The properties of a package to create. The defaults are those of `ros2 pkg create`."""

    name: str
    destination: str = os.curdir
    build_type: str = 'ament_cmake'
    license: str = 'TODO: License declaration'
    description: str = 'TODO: Package description'
    dependencies: tuple[str, ...] = ()
    maintainer_name: str = 'user'
    maintainer_email: str = 'user@todo.todo'
    node_name: str | None = None
    library_name: str | None = None

    @property
    def folder(self) -> str:
        """The folder of the new package."""
        return os.path.join(self.destination, self.name)


def write_python(package: NewPackage, writer: Any) -> None:
    """Write the files of a Python package in the order in which `ros2 pkg create` writes them."""
    name = package.name
    entry = f"            '{package.node_name} = {name}.{package.node_name}:main',\n" if package.node_name else ''
    writer.say('creating source folder')
    writer.folder(name)
    writer.file(
        'setup.py',
        SETUP.format(
            name=name,
            maintainer_name=package.maintainer_name,
            maintainer_email=package.maintainer_email,
            description=package.description,
            license=package.license,
            scripts=entry,
        ),
    )
    writer.file('setup.cfg', CONFIGURATION.format(name=name))
    writer.folder('resource')
    writer.file(f'resource/{name}', '')
    writer.file(f'{name}/__init__.py', '')
    writer.folder('test')
    for mark, (call, complaint) in LINTERS.items():
        writer.file(f'test/test_{mark}.py', LINTER.format(mark=mark, call=call, complaint=complaint))
    if package.library_name:
        writer.folder(f'{name}/{package.library_name}')
        writer.file(f'{name}/{package.library_name}/__init__.py', '')
    if package.node_name:
        writer.file(f'{name}/{package.node_name}.py', PYTHON_NODE.format(name=name))


HEAD = """\
cmake_minimum_required(VERSION 3.8)
project({name})

if(CMAKE_COMPILER_IS_GNUCXX OR CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  add_compile_options(-Wall -Wextra -Wpedantic)
endif()

# packages that this one needs
find_package(ament_cmake REQUIRED)
{finds}"""
LIBRARY = """
add_library({library} src/{library}.cpp)
target_include_directories({library} PUBLIC
  $<BUILD_INTERFACE:${{CMAKE_CURRENT_SOURCE_DIR}}/include>
  $<INSTALL_INTERFACE:include/${{PROJECT_NAME}}>)
target_compile_features({library} PUBLIC cxx_std_17)
{uses}install(DIRECTORY include/ DESTINATION include/${{PROJECT_NAME}})
install(TARGETS {library}
  ARCHIVE DESTINATION lib
  LIBRARY DESTINATION lib
  RUNTIME DESTINATION bin)
"""
NODE = """
add_executable({node} src/{node}.cpp)
target_include_directories({node} PUBLIC
  $<BUILD_INTERFACE:${{CMAKE_CURRENT_SOURCE_DIR}}/include>
  $<INSTALL_INTERFACE:include/${{PROJECT_NAME}}>)
target_compile_features({node} PUBLIC c_std_99 cxx_std_17)
{uses}install(TARGETS {node}
  DESTINATION lib/${{PROJECT_NAME}})
"""
TAIL = """
if(BUILD_TESTING)
  find_package(ament_lint_auto REQUIRED)
  ament_lint_auto_find_test_dependencies()
endif()

ament_package()
"""
MAIN = """\
#include <cstdio>

int main(int, char **)
{{
  std::printf("hello world {name} package\\n");
  return 0;
}}
"""
HEADER = """\
#ifndef {guard}
#define {guard}

namespace {name}
{{

class {type}
{{
public:
  {type}();
  virtual ~{type}();
}};

}}  // namespace {name}

#endif  // {guard}
"""
SOURCE = """\
#include "{name}/{library}.hpp"

namespace {name}
{{

{type}::{type}()
{{
}}

{type}::~{type}()
{{
}}

}}  // namespace {name}
"""


def write_cmake(package: NewPackage, writer: Any) -> None:
    """Write the files of a CMake package in the order in which `ros2 pkg create` writes them."""
    name, library, node = package.name, package.library_name, package.node_name
    writer.say('creating source and include folder')
    writer.folder('src')
    writer.folder(f'include/{name}')
    writer.file('CMakeLists.txt', cmake_text(package))
    if node:
        writer.file(f'src/{node}.cpp', MAIN.format(name=name))
    if library:
        words = {
            'name': name,
            'library': library,
            'type': ''.join(part.capitalize() for part in library.split('_')),
            'guard': f'{name}__{library}_HPP_'.upper(),
        }
        writer.file(f'include/{name}/{library}.hpp', HEADER.format(**words))
        writer.file(f'src/{library}.cpp', SOURCE.format(**words))


def cmake_text(package: NewPackage) -> str:
    """Return the content of the CMakeLists.txt of a package."""
    finds = ''.join(f'find_package({name} REQUIRED)\n' for name in package.dependencies)
    text = HEAD.format(name=package.name, finds=finds)
    for template, key, target in ((LIBRARY, 'library', package.library_name), (NODE, 'node', package.node_name)):
        if target:
            names = ''.join(f'\n  {name}' for name in package.dependencies)
            uses = f'ament_target_dependencies({target}{names}\n)\n\n' if names else '\n'
            text += template.format(**{key: target}, uses=uses)
    return text + TAIL


LICENSES = {
    'Apache-2.0': 'Apache License 2.0',
    'BSL-1.0': 'Boost Software License 1.0',
    'BSD-2.0': 'BSD 3-Clause "New" or "Revised" License',
    'BSD-2-Clause': 'BSD 2-Clause "Simplified" License',
    'BSD-3-Clause': 'BSD 3-Clause "New" or "Revised" License',
    'GPL-3.0-only': 'GNU General Public License v3.0 only',
    'LGPL-3.0-only': 'GNU Lesser General Public License v3.0 only',
    'MIT': 'MIT License',
    'MIT-0': 'MIT No Attribution',
}
SPDX = {'BSD-2.0': 'BSD-3-Clause'}


def license_notice(identifier: str, holder: str) -> str | None:
    """Return the content of the LICENSE file, or None for an unknown identifier.

    The content is the name of the license and the address of the license's text.

    :param identifier: the license, such as 'Apache-2.0'.
    :param holder: the name of the copyright holder.
    """
    if identifier not in LICENSES:
        return None
    spdx = SPDX.get(identifier, identifier)
    return (
        f'SPDX-License-Identifier: {spdx}\n\nCopyright holder: {holder}\n\n'
        f'This package may be used under the terms of the {LICENSES[identifier]}.\n'
        f'Full text: https://spdx.org/licenses/{spdx}.html\n'
    )
