"""The content of a recording: plain frozen data. Times are seconds since the start of the simulation."""

from __future__ import annotations

from typing import Any, NamedTuple

from edulaunch.engine.recording.views import view

PARAMETER_SERVICES = (
    'describe_parameters',
    'get_parameters',
    'get_parameter_types',
    'list_parameters',
    'set_parameters',
    'set_parameters_atomically',
    'get_type_description',
)
"""Services that every node of rclpy has, below its own name."""


class DeclaredArgument(NamedTuple):
    """A launch argument that a launch file declares. `default` is as in `ros2 launch -s`, or None for a required argument."""

    name: str
    default: str | None
    description: str
    choices: list[str] | None
    file: str | None
    line: int | None


class UnreadArgument(NamedTuple):
    """A launch argument that was passed, although no launch file declares or reads it. `declared` has the declared names.

    If an include at `file` and `line` passed the argument on, `included` is the included launch file.
    """

    name: str
    declared: list[str]
    included: str | None
    file: str | None
    line: int | None


class LaunchRecord(NamedTuple):
    """A launch and its result: `error` is launch's message, and `error_type`, `error_cause` and `error_facts` are its cause."""

    file: str = ''
    arguments: dict[str, str] = {}
    declared: list[DeclaredArgument] = []
    includes: list[str] = []
    returncode: int | None = None
    error: str | None = None
    error_file: str | None = None
    error_line: int | None = None
    error_type: str | None = None
    error_cause: str | None = None
    error_facts: dict[str, Any] = {}
    unread: list[UnreadArgument] = []

    @property
    def advice(self) -> tuple[str, str] | None:
        """The problem and what to do, in the reader's language. The property has the value None without an error, and for an
        error that no rule explains.
        """
        advice: tuple[str, str] | None = None if self.error is None else view('advice_of')(self)
        return advice

    @property
    def help(self) -> str | None:
        """The advice in one line, or None if there is no advice."""
        return '; '.join(filter(None, self.advice or ())) or None


class ProcessRecord(NamedTuple):
    """A launched program. While it runs, `returncode` has the value None. A signal gives a negative `returncode`. `exception` is
    the exception that ended the program, as a dict with type, message, file and line, or None.
    """

    name: str
    pid: int
    argv: list[str]
    package: str | None
    executable: str | None
    file: str | None
    line: int | None
    parameter_origins: dict[str, str]
    started_s: float
    ended_s: float | None = None
    returncode: int | None = None
    exception: dict[str, Any] | None = None

    @property
    def origin(self) -> tuple[str, int] | None:
        """The launch file and the line of the action that started the program, or None if the place is unknown."""
        return None if self.file is None or self.line is None else (self.file, self.line)


class NodeRecord(NamedTuple):
    """A node: its fully qualified name, the launch name of its process, and its endpoints as (name, type)."""

    name: str
    process: str
    started_s: float
    ended_s: float | None
    publishers: list[tuple[str, str]]
    subscriptions: list[tuple[str, str]]
    services: list[tuple[str, str]]
    clients: list[tuple[str, str]]


class EndRecord(NamedTuple):
    """A publisher, subscription, service or client (`kind`): absolute name, type, node, time of creation, and QoS policies."""

    kind: str
    name: str
    type: str
    node: str
    made_s: float
    qos: list[Any]


class TopicRecord(NamedTuple):
    """A topic: its (first) type, the fully qualified names of its publishers and subscribers, and its number of messages."""

    name: str
    type: str
    publishers: list[str]
    subscriptions: list[str]
    count: int  # type: ignore[assignment]  # this hides tuple.count, which is not needed here


class Parameter(NamedTuple):
    """The value of a parameter at the end of the run, and the origin of the value in words."""

    value: Any
    origin: str


class LogRecord(NamedTuple):
    """A log message of a node; `level` is 10 to 50 as in `rcl_interfaces/msg/Log`."""

    time_s: float
    process: str
    logger: str
    level: int
    message: str


class Output(NamedTuple):
    """A string that a program wrote to 'stdout' or 'stderr'."""

    time_s: float
    process: str
    stream: str
    text: str


class Note(NamedTuple):
    """A message from the engine to the user, for example about endpoints with incompatible QoS."""

    time_s: float
    process: str | None
    kind: str
    text: str


class Fact(NamedTuple):
    """An unusual fact about a program: its kind and data (see `Process.fact`), how often it occurred, and when first and last."""

    time_s: float
    process: str | None
    kind: str
    data: dict[str, Any]
    times: int
    last_s: float


class ServiceCall(NamedTuple):
    """A request, and its reply or None. `served` states whether a server existed; `replied_s` is the time of the reply."""

    time_s: float
    service: str
    type: str
    client: str
    request: Any
    served: bool
    replied_s: float | None
    response: Any


class Frame(NamedTuple):
    """A tf frame in its parent: translation in metres, rotation as (x, y, z, w), stamp of the transform in seconds."""

    parent: str
    translation: tuple[float, float, float]
    rotation: tuple[float, float, float, float]
    is_static: bool
    stamp_s: float
