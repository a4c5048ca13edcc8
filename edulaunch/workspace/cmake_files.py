"""The files of a new ament_cmake package."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.workspace.new_package import NewPackage

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


def write(package: NewPackage, writer: Any) -> None:
    """Write them, in the order of `ros2 pkg create`."""
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
    """The CMakeLists.txt."""
    finds = ''.join(f'find_package({name} REQUIRED)\n' for name in package.dependencies)
    text = HEAD.format(name=package.name, finds=finds)
    for template, key, target in ((LIBRARY, 'library', package.library_name), (NODE, 'node', package.node_name)):
        if target:
            names = ''.join(f'\n  {name}' for name in package.dependencies)
            uses = f'ament_target_dependencies({target}{names}\n)\n\n' if names else '\n'
            text += template.format(**{key: target}, uses=uses)
    return text + TAIL
