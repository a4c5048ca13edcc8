"""Programs that sleep inside a callback: a fact, of which advice is made when something else came late by that."""

from __future__ import annotations

from edulaunch.processes.student_line import student_line
from edulaunch.sim.task import current_task
from rclpy.execution.names import callback_name, node_name
from rclpy.process_state import process_state

SHORT_S = 0.01
"""A sleep that nobody notices."""


def note_sleep(seconds: float) -> None:
    """Told of each `time.sleep` of a program that has an executor; when the task that spins sleeps, it does so in a callback."""
    if not isinstance(seconds, (int, float)) or seconds < SHORT_S:
        return
    task, state = current_task(), process_state()
    for executor in (executor for context in state.contexts for executor in context.executors):
        if executor.spinner is task and (entity := executor.running_entity()) is not None:
            data = {'callback': callback_name(entity), 'node': node_name(entity), 'seconds': seconds}
            line = student_line()
            state.process.fact('sleep in callback', (line.get('file'), line.get('line')), {**data, **line})
            return
