"""Names are imported when used, and nobody notices."""

from __future__ import annotations

import ast
import importlib
import inspect
import pickle
import subprocess
import sys
from pathlib import Path

import pytest

from tests.house import UNDERLAY

PACKAGES = [
    'launch',
    'launch.actions',
    'launch.conditions',
    'launch.descriptions',
    'launch.event_handlers',
    'launch.events',
    'launch.events.process',
    'launch.launch_description_sources',
    'launch.substitutions',
    'launch.utilities',
    'launch_ros.actions',
    'launch_ros.descriptions',
    'launch_ros.event_handlers',
    'launch_ros.events.lifecycle',
    'launch_ros.substitutions',
    'launch_ros.utilities',
    'launch_testing.asserts',
]


PATHS = [
    'launch.action',
    'launch.actions',
    'launch.actions.append_environment_variable',
    'launch.actions.declare_launch_argument',
    'launch.actions.emit_event',
    'launch.actions.execute_local',
    'launch.actions.execute_process',
    'launch.actions.group_action',
    'launch.actions.include_launch_description',
    'launch.actions.log_info',
    'launch.actions.opaque_coroutine',
    'launch.actions.opaque_function',
    'launch.actions.pop_environment',
    'launch.actions.pop_launch_configurations',
    'launch.actions.push_environment',
    'launch.actions.push_launch_configurations',
    'launch.actions.register_event_handler',
    'launch.actions.reset_environment',
    'launch.actions.reset_launch_configurations',
    'launch.actions.set_environment_variable',
    'launch.actions.set_launch_configuration',
    'launch.actions.shutdown_action',
    'launch.actions.timer_action',
    'launch.actions.unregister_event_handler',
    'launch.actions.unset_environment_variable',
    'launch.actions.unset_launch_configuration',
    'launch.condition',
    'launch.conditions',
    'launch.conditions.evaluate_condition_expression_impl',
    'launch.conditions.if_condition',
    'launch.conditions.invalid_condition_expression_error',
    'launch.conditions.launch_configuration_equals',
    'launch.conditions.launch_configuration_not_equals',
    'launch.conditions.unless_condition',
    'launch.descriptions',
    'launch.descriptions.executable',
    'launch.event',
    'launch.event_handler',
    'launch.event_handlers',
    'launch.event_handlers.event_named',
    'launch.event_handlers.on_action_event_base',
    'launch.event_handlers.on_execution_complete',
    'launch.event_handlers.on_include_launch_description',
    'launch.event_handlers.on_process_exit',
    'launch.event_handlers.on_process_io',
    'launch.event_handlers.on_process_start',
    'launch.event_handlers.on_shutdown',
    'launch.events',
    'launch.events.execution_complete',
    'launch.events.include_launch_description',
    'launch.events.matchers',
    'launch.events.process',
    'launch.events.process.process_exited',
    'launch.events.process.process_io',
    'launch.events.process.process_matchers',
    'launch.events.process.process_started',
    'launch.events.process.process_stderr',
    'launch.events.process.process_stdin',
    'launch.events.process.process_stdout',
    'launch.events.process.process_targeted_event',
    'launch.events.process.running_process_event',
    'launch.events.process.shutdown_process',
    'launch.events.process.signal_process',
    'launch.events.shutdown',
    'launch.events.timer_event',
    'launch.frontend',
    'launch.frontend.entity',
    'launch.frontend.expose',
    'launch.frontend.invalid_frontend_launch_file_error',
    'launch.frontend.parse_substitution',
    'launch.frontend.parser',
    'launch.frontend.type_utils',
    'launch.invalid_launch_file_error',
    'launch.launch_context',
    'launch.launch_description',
    'launch.launch_description_entity',
    'launch.launch_description_source',
    'launch.launch_description_sources',
    'launch.launch_description_sources.any_launch_description_source',
    'launch.launch_description_sources.any_launch_file_utilities',
    'launch.launch_description_sources.frontend_launch_description_source',
    'launch.launch_description_sources.frontend_launch_file_utilities',
    'launch.launch_description_sources.python_launch_description_source',
    'launch.launch_description_sources.python_launch_file_utilities',
    'launch.launch_introspector',
    'launch.launch_service',
    'launch.logging',
    'launch.logging.handlers',
    'launch.some_actions_type',
    'launch.some_entities_type',
    'launch.some_substitutions_type',
    'launch.substitution',
    'launch.substitutions',
    'launch.substitutions.anon_name',
    'launch.substitutions.boolean_substitution',
    'launch.substitutions.command',
    'launch.substitutions.environment_variable',
    'launch.substitutions.equals_substitution',
    'launch.substitutions.file_content',
    'launch.substitutions.find_executable',
    'launch.substitutions.if_else_substitution',
    'launch.substitutions.launch_configuration',
    'launch.substitutions.launch_log_dir',
    'launch.substitutions.local_substitution',
    'launch.substitutions.not_equals_substitution',
    'launch.substitutions.path_join_substitution',
    'launch.substitutions.path_substitution',
    'launch.substitutions.python_expression',
    'launch.substitutions.string_join_substitution',
    'launch.substitutions.substitution_failure',
    'launch.substitutions.text_substitution',
    'launch.substitutions.this_launch_file',
    'launch.substitutions.this_launch_file_dir',
    'launch.utilities',
    'launch.utilities.class_tools_impl',
    'launch.utilities.ensure_argument_type_impl',
    'launch.utilities.normalize_to_list_of_entities_impl',
    'launch.utilities.normalize_to_list_of_substitutions_impl',
    'launch.utilities.perform_substitutions_impl',
    'launch.utilities.signal_management',
    'launch.utilities.type_utils',
    'launch.utilities.typing_file_path',
    'launch.utilities.visit_all_entities_and_collect_futures_impl',
    'launch_ros.actions',
    'launch_ros.actions.composable_node_container',
    'launch_ros.actions.lifecycle_node',
    'launch_ros.actions.lifecycle_transition',
    'launch_ros.actions.load_composable_nodes',
    'launch_ros.actions.node',
    'launch_ros.actions.push_ros_namespace',
    'launch_ros.actions.ros_timer',
    'launch_ros.actions.set_parameter',
    'launch_ros.actions.set_parameters_from_file',
    'launch_ros.actions.set_remap',
    'launch_ros.actions.set_ros_log_dir',
    'launch_ros.actions.set_use_sim_time',
    'launch_ros.descriptions',
    'launch_ros.descriptions.composable_node',
    'launch_ros.event_handlers',
    'launch_ros.event_handlers.on_state_transition',
    'launch_ros.events',
    'launch_ros.events.lifecycle',
    'launch_ros.events.lifecycle.change_state',
    'launch_ros.events.lifecycle.matches_node_name',
    'launch_ros.events.lifecycle.state_transition',
    'launch_ros.events.matchers',
    'launch_ros.parameter_descriptions',
    'launch_ros.parameters_type',
    'launch_ros.remap_rule_type',
    'launch_ros.ros_adapters',
    'launch_ros.substitutions',
    'launch_ros.substitutions.executable_in_package',
    'launch_ros.substitutions.find_package',
    'launch_ros.substitutions.parameter',
    'launch_ros.utilities',
    'launch_ros.utilities.evaluate_parameters',
    'launch_ros.utilities.namespace_utils',
    'launch_ros.utilities.normalize_parameters',
    'launch_ros.utilities.normalize_remap_rule',
    'launch_ros.utilities.plugin_support',
    'launch_ros.utilities.to_parameters_list',
    'launch_ros.utilities.track_node_names',
    'launch_testing.actions',
    'launch_testing.actions.ready',
    'launch_testing.asserts',
    'launch_testing.asserts.assert_exit_codes',
    'launch_testing.asserts.assert_output',
    'launch_testing.asserts.assert_sequential_output',
    'launch_testing.decorator',
    'launch_testing.event_handlers',
    'launch_testing.event_handlers.stdout_ready_listener',
    'launch_testing.io_handler',
    'launch_testing.junitxml',
    'launch_testing.launch_test',
    'launch_testing.loader',
    'launch_testing.markers',
    'launch_testing.parametrize',
    'launch_testing.proc_info_handler',
    'launch_testing.pytest',
    'launch_testing.pytest.hooks',
    'launch_testing.test_result',
    'launch_testing.test_runner',
    'launch_testing.tools',
    'launch_testing.tools.text',
    'launch_testing.util',
    'launch_testing.util.keep_alive_proc',
    'launch_testing.util.proc_lookup',
    'launch_testing_ros.message_pump',
    'launch_testing_ros.wait_for_topics',
    'launch_xml.entity',
    'launch_xml.launch_description_sources',
    'launch_xml.parser',
    'launch_yaml.entity',
    'launch_yaml.launch_description_sources',
    'launch_yaml.parser',
    'ros2launch.api',
    'ros2launch.api.api',
]
"""The paths at which launch's modules are in ROS 2."""


@pytest.mark.processes
def test_every_module_of_ros_can_be_imported_at_its_path_alone() -> None:
    """Each in a row of its own order: the last first, so that none finds its file loaded by one before."""
    for paths in (PATHS, PATHS[::-1]):
        _run(''.join(f'import {path}\nassert {path} is not None\n' for path in paths))


@pytest.mark.parametrize('package', PACKAGES)
def test_a_class_says_the_path_that_it_has_in_ros_and_comes_back_from_it(package: str) -> None:
    module = importlib.import_module(package)
    for name in dir(module):
        value = getattr(module, name)
        if isinstance(value, type):
            assert value.__module__ in PATHS
            assert vars(sys.modules[value.__module__])[name].__module__ == value.__module__, 'it lives where it says'
            assert pickle.loads(pickle.dumps(value)) is value
            assert inspect.getsource(value).startswith(f'class {value.__name__}')


@pytest.mark.parametrize('package', PACKAGES)
def test_every_exported_name_is_there_and_lives_below_its_package(package: str) -> None:
    module = importlib.import_module(package)
    for name in module.__all__:
        value = getattr(module, name)
        assert getattr(value, '__module__', 'launch').startswith('launch') or name.startswith('Some')


@pytest.mark.parametrize('package', PACKAGES)
def test_star_imports_everything(package: str) -> None:
    names: dict[str, object] = {}
    exec(f'from {package} import *', names)
    assert set(importlib.import_module(package).__all__) <= set(names)


LATE = [path for path in sorted(UNDERLAY.glob('launch*/**/__init__.py')) if 'late_names(' in path.read_text(encoding='utf-8')]


@pytest.mark.parametrize('path', LATE, ids=lambda path: '.'.join(path.relative_to(UNDERLAY).parts[:-1]))
def test_type_checkers_and_the_table_of_a_package_read_the_same(path: Path) -> None:
    """Else `mypy` and an editor would know another package than the one that runs."""
    tree = ast.parse(path.read_text(encoding='utf-8'))
    block = next(node for node in tree.body if isinstance(node, ast.If) and 'TYPE_CHECKING' in ast.unparse(node.test))
    plain = {(alias.name, one.module) for one in block.body if isinstance(one, ast.ImportFrom) for alias in one.names}
    call = next(node for node in ast.walk(block) if isinstance(node, ast.Call))
    keywords = {item.arg: ast.literal_eval(item.value) for item in call.keywords if item.arg != 'absent'}
    modules = {*keywords.get('modules', ()), *keywords.get('attributes', ())}
    assert plain == {*ast.literal_eval(call.args[1]).items(), *((name, None) for name in modules)}
    package = importlib.import_module('.'.join(path.relative_to(UNDERLAY).parts[:-1]))
    assert all(hasattr(package, name) for name, _ in plain)


MODULES_OF_THAT_NAME = {'parse_substitution'}
"""ROS 2's launch.frontend exports the module, not its function."""


@pytest.mark.parametrize('path', LATE, ids=lambda path: '.'.join(path.relative_to(UNDERLAY).parts[:-1]))
def test_a_function_with_the_name_of_its_module_is_imported_at_once(path: Path) -> None:
    """Else the import of the module would put the module in the function's place."""
    package = importlib.import_module('.'.join(path.relative_to(UNDERLAY).parts[:-1]))
    exported = set(package.__all__) - MODULES_OF_THAT_NAME
    for one in path.parent.glob('*.py'):
        if hasattr(importlib.import_module(f'{package.__name__}.{one.stem}'), one.stem) and one.stem in exported:
            assert callable(getattr(package, one.stem)), f'{package.__name__}.{one.stem} is the module'


def test_a_missing_name_gives_pythons_own_error() -> None:
    import launch.actions

    with pytest.raises(ImportError) as error:
        from launch.actions import IfCondition  # noqa: F401
    assert str(error.value) == f"cannot import name 'IfCondition' from 'launch.actions' ({launch.actions.__file__})"
    with pytest.raises(AttributeError, match="module 'launch.actions' has no attribute 'X'"):
        _ = launch.actions.X


@pytest.mark.processes
def test_modules_are_attributes_without_an_import() -> None:
    code = (
        'import launch\nlaunch.actions.timer_action.TimerAction\nlaunch.event_handlers.OnProcessExit\n'
        'launch.launch_description_sources.PythonLaunchDescriptionSource\nlaunch.substitution.Substitution'
    )
    _run(code)


@pytest.mark.processes
def test_a_description_can_be_built_without_asyncio_logging_or_yaml() -> None:
    _run(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess, TimerAction\n'
        'TimerAction(period=1.0, actions=[])\nimport sys\n'
        'assert not {"asyncio", "logging", "yaml", "numpy", "matplotlib", "argparse"} & set(sys.modules)'
    )


def _run(code: str) -> None:
    root = Path(__file__).resolve().parents[3]
    start = f'import sys; sys.path[:0] = [{str(root)!r}, {str(root / "edulaunch" / "ros" / "python")!r}]\n'
    subprocess.run([sys.executable, '-S', '-c', start + f'sys.path += {sys.path!r}\n' + code], check=True)
