"""The kinds and payloads of frames between the peers. A payload is JSON, or the CDR bytes of a message, and nothing else."""

from __future__ import annotations

import json
from enum import IntEnum
from typing import Any

from edulaunch.engine.interfaces.registry import Registry
from edulaunch.errors import EdulaunchError, InterfaceError
from edulaunch.ros.serialization.cdr import decode, encode

LONGEST_FRAME = 16 << 20


class Violation(EdulaunchError):
    """The other peer has sent a frame that edulaunch's code never sends."""


class FrameKind(IntEnum):
    """The kinds of frames. The sender of a call waits for RETURN. Other frames are handled when they arrive."""

    TOKEN = 1  # the other peer runs now
    RETURN = 2
    ADVANCE = 3  # the sender's time
    MARK = 4  # the following items have this number
    NODE = 5
    NODE_GONE = 6
    END = 7  # a new endpoint
    END_GONE = 8
    PUBLISH = 9
    READY = 10  # a message reached a subscription
    ALIVE = 11
    ASKED = 12  # a request was sent (only for the recording)
    REQUEST = 13  # a call: a request reached a server
    ANSWERED = 14  # a reply was sent to its client (only for the recording)
    RESPONSE = 15  # a reply reached a client
    PARAMETER = 16
    STARTED = 17  # a program of the confined peer began
    ENDED = 18
    WROTE = 19
    LOG = 20
    NOTE = 21
    FACT = 29
    FACT_OVER = 30
    DESCRIPTOR = 32
    WATCH = 31  # a node may report facts at the end
    SPAWN = 22  # the trusted peer should host a program
    SIGNAL = 23  # a call, for a hosted program
    HEARD = 24  # whether a hosted program's output is recorded
    OUTPUT = 25  # a call: a hosted program wrote
    EXIT = 26  # a call: a hosted program ended
    ENTRIES = 27  # a call: the entries of a parameter file
    FINISH = 28  # a call: the run has ended, with the facts of its launch
    MAY_START = 33  # a call: whether a program can be started
    TEMPORARY = 34  # the path of a temporary file or folder


def dump(value: Any) -> bytes:
    """Return plain data as JSON. Bytes have the form {"bytes": hex}."""
    return json.dumps(value, default=_plain, separators=(',', ':')).encode()


def _plain(value: Any) -> Any:
    if isinstance(value, (bytes, bytearray)):
        return {'bytes': value.hex()}
    if hasattr(value, 'tolist'):  # arrays
        return value.tolist()
    raise TypeError(f'{type(value).__name__} is not plain data')


def load(data: bytes) -> Any:
    """Return plain data from JSON.

    :raises Violation: for invalid data.
    """
    try:
        return json.loads(data, object_hook=_bytes_back)
    except (ValueError, RecursionError) as error:
        raise Violation(f'no JSON: {type(error).__name__}') from None


def _bytes_back(found: dict[str, Any]) -> Any:
    if len(found) == 1 and isinstance(found.get('bytes'), str):
        return bytes.fromhex(found['bytes'])
    return found


AS_BEFORE, AS_CDR, AS_JSON = 0, 1, 2


class Messages:
    """Converts wire tuples to bytes and back: CDR for the types of one registry, and JSON for the types of a student.

    :param registry: the registry of the stock types. Other types have no class here.
    """

    def __init__(self, registry: Registry) -> None:
        self._registry = registry
        self._stock: dict[str, Any] = {}
        self._checks: Any = None

    def type(self, name: str) -> Any:
        """Return the class of a stock type. For another type, return an object that contains only the name."""
        if name not in self._stock:
            try:
                self._stock[name] = self._registry.get(name)
            except (InterfaceError, ValueError):
                self._stock[name] = ForeignType(name)
        return self._stock[name]

    def packed(self, cls: Any, wire: Any) -> bytes:
        """Return a wire tuple of a class as bytes. The first byte states the format."""
        if self.type_of(cls) is cls:
            try:
                return bytes((AS_CDR,)) + encode(cls, wire)
            except UnicodeError:
                pass
        return bytes((AS_JSON,)) + dump(wire)

    def type_of(self, cls: Any) -> Any:
        """Return the stock class with the same name. For a class of another registry without such a counterpart, return what
        :meth:`type` returns.
        """
        name: str = cls.TYPE
        return self.type(name) if name.count('/') == 2 else cls

    def unpacked(self, cls: Any, data: bytes) -> Any:
        """Return the wire tuple from its bytes.

        :raises Violation: when the bytes are not a message of that class.
        """
        if data[:1] == bytes((AS_CDR,)) and not isinstance(cls, ForeignType):
            try:
                return decode(cls, data[1:])
            except InterfaceError as error:
                raise Violation(str(error)) from None
        if data[:1] != bytes((AS_JSON,)):
            raise Violation(f'not a message of type {cls.TYPE}')
        wire = tuples(load(data[1:]))
        if not isinstance(cls, ForeignType) and not self._fits(cls.TYPE, wire):
            raise Violation(f'not a message of type {cls.TYPE}')
        return wire

    def _fits(self, name: str, wire: Any) -> bool:
        from edulaunch.engine.recording.wire_check import WireChecks

        if self._checks is None:
            self._checks = WireChecks(self._registry)
        return bool(self._checks.check(name)([wire]))


class ForeignType:
    """A student's own type, in the peer that has only its name."""

    def __init__(self, name: str) -> None:
        self.TYPE = name
        if '/srv/' in name or '/action/' in name:
            self.Request = self.Response = self


def tuples(value: Any) -> Any:
    return tuple(tuples(each) for each in value) if isinstance(value, list) else value
