"""Run a launch file in a dry run, and create the plan."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from functools import partial
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from edulaunch.advice.plan.assumptions import Assumptions, include_if_there
from edulaunch.advice.plan.rehearsal import (
    TURN_LIMIT_S,
    ImaginedLifecycles,
    Notes,
    RehearsalHost,
    run_to_rest,
    runaway_error,
    still_busy,
)
from edulaunch.advice.plan.titles import Branch, Setters
from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.packages import Index
from edulaunch.engine.processes.commands import CommandSet
from edulaunch.engine.processes.watchdog import RunawayProgram, Watchdog
from edulaunch.engine.recording.views import view
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.ros.collector_pause import collector_paused
from edulaunch.runtime.shell import SimulatedShell

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process

FORMAT = 1
Plan = dict[str, Any]
_SCALARS = frozenset((str, int, float, bool, type(None)))
"""Types of values that stay unchanged. This check without a call halves the time for the 56 values of a node."""
_KEY = itemgetter(0)
_OF_LAUNCH = frozenset(('timer', 'emit_event'))
"""Events with which launch itself ends a process. They belong to the user only if a launch file created them."""


class Planner:
    """A launch service in a separate simulation that starts no programs.

    :ivar assumptions: the replacements for missing packages, or None if the dry run makes no assumptions.
    :ivar read: the names of the launch configurations that substitutions have read.
    """

    def __init__(
        self, path: str, given: dict[str, str], index: Index, environ: Mapping[str, str], command_set: CommandSet | None
    ) -> None:
        self._path = path
        self._given = given
        self._notes = Notes()
        self._sim = Simulation()
        self._host = RehearsalHost(
            self._sim,
            Graph(self._sim, self._notes),
            index,
            env=environ,
            command_set=command_set or CommandSet(shell=SimulatedShell()),
        )
        self._host.watchdog = Watchdog(self._sim, TURN_LIMIT_S)
        self._items: list[Plan] = []
        self._processes = 0
        self._error: Plan | None = None
        self._arguments: list[Plan] = []
        self._configurations: dict[str, Any] = {}
        self._reason: str | None = None
        self._broken: Exception | None = None
        self._service: Any = None
        self._watch: Any = None
        self._setters = Setters()
        self.assumptions: Assumptions | None = None
        self.read: Mapping[str, bool] = {}

    @property
    def outline(self) -> Branch:
        """The root of the branches that launch visited."""
        return Branch('') if self._watch is None else self._watch.outline

    def plan(self) -> Plan:
        """Run the launch file, and return the plan."""
        with collector_paused():
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter('default')
                endless = self._run_to_the_end()
            self._host.close()
            self._host.closed.close()
            if endless is not None:
                self._error = self._endless_error(endless)
            if self._broken is not None:
                raise self._broken
            plan = {
                'format': FORMAT,
                'file': self._path,
                'given': _plain(self._given),
                'arguments': _plain(self._arguments),
                'configurations': self._configurations,
                'items': self._items,
                'error': _plain(self._error),
                'log': self._notes.logs,
                'shutdown_reason': self._reason,
                'stdout': self._notes.stdout,
                'warnings': [str(warning.message) for warning in caught],
                **({'not_done': self._host.closed.notes} if self._host.closed.notes else {}),
            }
            return dict(sorted(plan.items()))

    def _run_to_the_end(self) -> str | None:
        """Run until the launch ends. Return an error message if it does not end, otherwise None."""
        process = self._host.run_launch(self._run)
        endless = run_to_rest(self._sim)
        while endless is None and process.returncode is None:
            self._let_something_end()
            endless = run_to_rest(self._sim)
        if endless is None and self._watch is not None and self._watch.is_endless:
            endless = still_busy(self._sim)
        return endless

    def _endless_error(self, text: str) -> Plan:
        branch = self._watch.branch
        origin = None if branch.origin is None else str(branch.origin)
        where = '' if origin is None else f'{origin} ({type(branch.action).__name__}): '
        help_text = (
            f'{where}give an end to a handler whose own actions cause its event, a timer that starts itself again, '
            'or a coroutine that never returns'
        )
        return {'type': 'RuntimeError', 'text': text, 'help': help_text, 'origin': origin, 'stage': 'visit'}

    def _let_something_end(self) -> None:
        if self._host.end_next():
            return
        from launch.events.shutdown import Shutdown

        if not self._service.context.is_shutdown:
            self._service.emit_event(Shutdown(reason='idle'))
        else:
            self._host.end_all()

    def _run(self, process: Process) -> int:
        """Run launch inside a process.

        Return the exit code. An exception here is a bug of edulaunch, which is stored for later.
        """
        try:
            process.state['launch.on_error'] = self._failed
            process.state['launch.assumptions'] = self.assumptions
            process.state['launch.change_state'] = ImaginedLifecycles().change
            self.read = process.state.setdefault('launch.read', {})
            return self._launch()
        except RunawayProgram as error:
            self._error = runaway_error(error)
            return 1
        except Exception as error:
            self._broken = error
            return 1

    def _launch(self) -> int:
        import logging

        import launch.logging
        from launch.actions.include_launch_description import IncludeLaunchDescription
        from launch.event_handlers.on_shutdown import OnShutdown
        from launch.launch_description import LaunchDescription
        from launch.launch_description_sources.any_launch_description_source import AnyLaunchDescriptionSource
        from launch.launch_service import LaunchService

        from edulaunch.advice.plan.watching import Watch

        launch.logging.launch_config.dry = True
        # a plan records warnings, and a line for each started process takes time
        launch.logging.launch_config.level = logging.WARNING
        launch.logging.launch_config.get_screen_handler().setLevel(logging.CRITICAL + 1)
        source = AnyLaunchDescriptionSource(self._path)
        self._arguments = _declared_arguments(source)
        self._service = LaunchService(noninteractive=True)
        instead: dict[str, Any] = {'LoadComposableNodes': lambda action, context: None}
        if self.assumptions is not None:
            instead['IncludeLaunchDescription'] = partial(include_if_there, self.assumptions)
        self._watch = Watch(self._executed, instead, self._host.came_back)
        context = self._service.context
        context.observer = self._watch
        context.register_event_handler(OnShutdown(on_shutdown=self._note_reason))
        include = IncludeLaunchDescription(source, launch_arguments=list(self._given.items()))
        self._service.include_launch_description(LaunchDescription([include, self._end_of_first_visit()]))
        code: int = self._service.run()
        return code

    def _note_reason(self, event: Any, context: Any) -> None:
        self._reason = self._reason or event.reason

    def _end_of_first_visit(self) -> Any:
        from launch.launch_description_entity import LaunchDescriptionEntity

        class End(LaunchDescriptionEntity):
            def visit(end, context: Any) -> None:
                self._configurations = _plain(dict(context.launch_configurations))

        return End()

    def _executed(self, branch: Branch, context: Any) -> None:
        from edulaunch.advice.plan.items import item_of
        from edulaunch.advice.plan.process_items import add_names_and_parameters, add_parameter_sources

        item = item_of(branch.action, context, self._host.env, self._processes)
        if item is None or (branch.origin is None and item['kind'] in _OF_LAUNCH):
            self._setters.executed(branch)
            return
        self._processes += item['kind'] in ('node', 'process')
        item['phase'] = self._watch.phase
        if self._watch.phase == 'timer':
            item['time'] = self._sim.elapsed_s
        if item['kind'] == 'node':
            add_parameter_sources(item, self._host)
            add_names_and_parameters(item, self._host.parameter_entries)
        branch.item = _plain(item)
        self._items.append(branch.item)
        self._setters.executed(branch)

    def _failed(self, error: BaseException) -> None:
        from launch._failure import failure_data, launch_origin

        if self._error is None:
            origin, data = launch_origin(error), failure_data(error)
            self._error = {
                'type': type(error).__name__,
                'text': str(error),
                'facts': data['facts'],
                'cause': {'type': data['type'], 'text': data['message']},
                'help': view('help_of')(data),
                'origin': None if origin is None else str(origin),
                'stage': 'visit' if self._items else 'load',
            }


def _declared_arguments(source: Any) -> list[Plan]:
    """Return the arguments that a launch file declares. The visit uses the same loaded file, which the source caches."""
    from launch.launch_context import LaunchContext

    try:
        found = source.get_launch_description(LaunchContext()).get_launch_arguments()
    except Exception:
        return []  # visiting the entity raises the same error, and reports it
    return [
        {
            'name': argument.name,
            'description': argument.description,
            'choices': argument.choices,
            'conditional': argument._conditionally_included,
            'default': None if argument.default_value is None else ' + '.join(part.describe() for part in argument.default_value),
        }
        for argument in found
    ]


def _plain(value: Any) -> Any:
    """Return a value as data for JSON, with sorted keys."""
    kind = type(value)
    if kind in _SCALARS:
        return value
    if kind is list:
        return [item if type(item) in _SCALARS else _plain(item) for item in value]
    if kind is dict or isinstance(value, Mapping):  # check `kind` first: it is ten times as fast
        texts = sorted([(str(key), item) for key, item in value.items()], key=_KEY)
        return {key: item if type(item) in _SCALARS else _plain(item) for key, item in texts}
    if isinstance(value, (list, tuple)):
        return _plain(list(value))
    return value if isinstance(value, (str, int, float)) else str(value)
