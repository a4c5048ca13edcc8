"""What a CMakeLists.txt installs, read without running CMake."""

from __future__ import annotations

from typing import Any

import pytest

FILES = {
    'launch/a.launch.py': '',
    'launch/sub/b.launch.xml': '',
    'config/p.yaml': '',
    'scripts/node.py': '#!/usr/bin/env python3\n',
    'msg/Num.msg': 'int64 num\n',
    'srv/Add.srv': '---\n',
    'msg/Unlisted.msg': 'int64 a\n',
}


@pytest.mark.parametrize(
    ('install', 'expected'),
    [
        ('install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})', ['launch/a.launch.py', 'launch/sub/b.launch.xml']),
        ('install(DIRECTORY launch/ DESTINATION share/${PROJECT_NAME}/)', ['a.launch.py', 'sub/b.launch.xml']),
        (
            'install(DIRECTORY\n  launch\n  config  # both\n  DESTINATION share/${PROJECT_NAME}\n)',
            ['config/p.yaml', 'launch/a.launch.py', 'launch/sub/b.launch.xml'],
        ),
        (
            'install(FILES launch/a.launch.py DESTINATION "share/${PROJECT_NAME}/launch" RENAME z.launch.py)',
            ['launch/z.launch.py'],
        ),
        (
            ('file(GLOB FOUND "config/*.yaml")\ninstall(FILES ${FOUND} DESTINATION share/${PROJECT_NAME}/config)'),
            ['config/p.yaml'],
        ),
        (
            (
                'set(DIRS launch config)\nforeach(d ${DIRS})\n  INSTALL(DIRECTORY ${d} DESTINATION '
                'share/${PROJECT_NAME})\nendforeach()'
            ),
            ['config/p.yaml', 'launch/a.launch.py', 'launch/sub/b.launch.xml'],
        ),
        ('install(DIRECTORY launch DESTINATION share/robo FILES_MATCHING PATTERN "*.py")', ['launch/a.launch.py']),
        (
            'install(DIRECTORY launch config DESTINATION share/robo FILES_MATCHING PATTERN "*.xml" PATTERN "*.yaml")',
            ['config/p.yaml', 'launch/sub/b.launch.xml'],
        ),
        (
            'install(DIRECTORY launch DESTINATION share/robo FILES_MATCHING PATTERN "*.py" PATTERN "*.xml" PATTERN "sub" EXCLUDE)',
            ['launch/a.launch.py'],
        ),
        ('install(DIRECTORY launch DESTINATION share/robo PATTERN "sub" EXCLUDE)', ['launch/a.launch.py']),
        ('ament_auto_package(INSTALL_TO_SHARE config)', ['config/p.yaml']),
        (
            (
                'function(install_folder name)\n  install(DIRECTORY ${name} ${ARGN} DESTINATION share/robo)\n'
                'endfunction()\ninstall_folder(config launch)'
            ),
            ['config/p.yaml', 'launch/a.launch.py', 'launch/sub/b.launch.xml'],
        ),
        (('if(BUILD_TESTING)\n  if(X)\n  endif()\n  install(DIRECTORY config DESTINATION share/robo)\nendif()'), []),
        (
            'get_filename_component(HERE ${CMAKE_CURRENT_SOURCE_DIR}/launch/.. ABSOLUTE)\n'
            'install(DIRECTORY ${HERE}/config DESTINATION share/robo)',
            ['config/p.yaml'],
        ),
        (
            'get_filename_component(TOP ${CMAKE_CURRENT_SOURCE_DIR}/config/p.yaml DIRECTORY)\n'
            'get_filename_component(NAME config/p.yaml NAME_WE)\n'
            'install(FILES ${TOP}/${NAME}.yaml DESTINATION share/robo)',
            ['p.yaml'],
        ),
        ('#[[ install(DIRECTORY config DESTINATION share/robo) ]]', []),
    ],
)
def test_install_rules_are_followed(workspace: Any, install: str, expected: list[str]) -> None:
    workspace.cmake_package('robo', f'project(robo)\n{install}\nament_package()\n', FILES)
    assert workspace.installed('robo') == sorted([*expected, 'package.xml'])
    assert workspace.warnings('robo') == []


def test_installed_programs_are_scripts_that_keep_their_source_file(workspace: Any) -> None:
    workspace.cmake_package('robo', 'project(robo)\ninstall(PROGRAMS scripts/node.py DESTINATION lib/${PROJECT_NAME})', FILES)
    index = workspace.index()
    program = index.find_program(f'{index.prefix("robo")}/lib/robo/node.py')
    assert (program.kind, program.file) == ('script', str(workspace.path / 'robo' / 'scripts' / 'node.py'))


def test_a_file_that_is_installed_as_executable_is_a_program(workspace: Any) -> None:
    rule = 'install(FILES scripts/node.py DESTINATION lib/robo PERMISSIONS OWNER_READ OWNER_EXECUTE)'
    workspace.cmake_package('robo', f'project(robo)\n{rule}', FILES)
    assert workspace.index().executables('robo') == ['node.py']


def test_only_listed_interfaces_are_generated(workspace: Any) -> None:
    workspace.cmake_package(
        'robo',
        'project(robo)\nset(msgs msg/Num.msg)\nlist(APPEND msgs "srv/Add.srv")\n'
        'rosidl_generate_interfaces(${PROJECT_NAME} ${msgs} DEPENDENCIES std_msgs)',
        FILES,
    )
    assert workspace.installed('robo') == ['msg/Num.msg', 'package.xml', 'srv/Add.srv']
    index = workspace.index()
    assert index.interface_roots() == [index.share('robo')]


def test_a_python_library_of_a_cmake_package_can_be_imported(workspace: Any) -> None:
    workspace.cmake_package('robo', 'project(robo)\nament_python_install_package(${PROJECT_NAME})', {'robo/__init__.py': ''})
    assert workspace.index().python_modules() == {'robo': str(workspace.path / 'robo' / 'robo')}


def test_native_executables_are_known_but_not_offered(workspace: Any) -> None:
    workspace.cmake_package(
        'robo', 'project(robo)\n\nadd_executable(drive src/d.cpp)\ninstall(TARGETS drive DESTINATION lib/robo)'
    )
    index = workspace.index()
    assert index.executables('robo') == []
    assert index.native_executables('robo') == {'drive': f'{workspace.path}/robo/CMakeLists.txt:3'}


@pytest.mark.parametrize(
    ('line', 'sentence'),
    [
        ('install(FILES none.yaml DESTINATION share/robo)', 'none.yaml is not there, so the package does not build'),
        ('install(DIRECTORY maps DESTINATION share/robo)', 'installs the folder maps/, which does not exist'),
        (
            'install(FILES ${GENERATED} DESTINATION share/robo)',
            'uses ${GENERATED}, whose value is not known without running CMake',
        ),
        ('install(DIRECTORY launch)', 'install(DIRECTORY ...) has no DESTINATION'),
        ('rosidl_generate_interfaces(other "msg/Num.msg")', 'rosidl_generate_interfaces(other ...) must name the package, robo'),
    ],
)
def test_what_cannot_be_built_is_a_warning_with_its_line(workspace: Any, line: str, sentence: str) -> None:
    workspace.cmake_package('robo', f'project(robo)\n{line}\n', FILES)
    assert workspace.warnings('robo') == [f'robo/CMakeLists.txt:2: {sentence}']


def test_interfaces_may_have_a_target_of_their_own(workspace: Any) -> None:
    text = 'project(robo)\nrosidl_generate_interfaces(other "msg/Num.msg" LIBRARY_NAME robo)\n'
    workspace.cmake_package('robo', text, {**FILES, 'msg/Num.msg': 'int32 n\n'})
    assert workspace.warnings('robo') == []


def test_programs_have_the_names_under_which_they_are_built(workspace: Any) -> None:
    workspace.cmake_package(
        'robo',
        'project(robo)\n'
        'add_executable(drive_target drive.cpp)\n'
        'set_target_properties(drive_target PROPERTIES OUTPUT_NAME drive)\n'
        'install(TARGETS drive_target DESTINATION lib/robo)\n'
        'rclcpp_components_register_node(parts PLUGIN "robo::Eye" EXECUTABLE eye)\n'
        'if(BUILD_TESTING)\n'
        '  ament_add_gtest(test_drive test_drive.cpp)\n'
        '  install(TARGETS test_drive DESTINATION lib/robo)\n'
        'endif()\n',
    )
    assert sorted(workspace.index().native_executables('robo')) == ['drive', 'eye', 'test_drive']


def test_what_the_build_makes_is_not_looked_for_in_the_sources(workspace: Any) -> None:
    workspace.cmake_package(
        'robo',
        'project(robo)\n'
        'configure_file(a.launch.py.in ${CMAKE_CURRENT_BINARY_DIR}/a.launch.py)\n'
        'install(FILES ${CMAKE_CURRENT_BINARY_DIR}/a.launch.py DESTINATION share/robo/launch)\n'
        'install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/maps DESTINATION share/robo)\n',
    )
    index = workspace.index()
    index.contents('robo')
    assert index.warnings == ()


def test_folders_below_are_followed_and_their_projects_are_their_own(workspace: Any) -> None:
    files = {
        'demo/CMakeLists.txt': 'project(demo)\ninstall(DIRECTORY launch DESTINATION share/robo)\n',
        'demo/launch/a.launch.py': '',
        'b.yaml': '',
    }
    text = (
        'project(robo)\nadd_subdirectory(demo)\nadd_subdirectory(..)\ninstall(FILES b.yaml DESTINATION share/${PROJECT_NAME})\n'
    )
    workspace.cmake_package('robo', text, files)
    index = workspace.index()
    assert {'share/robo/launch/a.launch.py', 'share/robo/b.yaml'} <= {*index.contents('robo').files}
    assert index.warnings == () and index.contents('robo').unread == ''


@pytest.mark.parametrize(
    ('lines', 'unread'),
    [
        ('if(WITH_MAPS)\ninstall(DIRECTORY maps DESTINATION share/robo)\nendif()', ''),
        ('install(CODE "message(done)")', ''),
        ('install(FILES a.h TYPE INCLUDE)', ''),
        ('company_install_all()', 'company_install_all()'),
    ],
)
def test_what_a_build_may_well_accept_is_no_warning(workspace: Any, lines: str, unread: str) -> None:
    workspace.cmake_package('robo', f'project(robo)\n{lines}\n', {'a.h': ''})
    assert workspace.warnings('robo') == []
    assert workspace.index().contents('robo').unread == unread
