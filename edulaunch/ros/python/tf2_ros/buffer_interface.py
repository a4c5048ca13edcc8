"""The common part of all sources of transforms. It transforms stamped objects with functions that packages register by type.

Packages that come with edulaunch (`tf2_geometry_msgs`) are imported once for all processes. As in ROS 2, their functions are
valid only in processes that import them. A function that a program registers is valid only in the process of that program.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy.duration import Duration

from edulaunch.engine.processes.current import current_process
from edulaunch.ros.passed_on import passed_on

Key = Any
_provided: dict[str, dict[Key, Callable[..., Any]]] = {'transform': {}, 'to_msg': {}, 'from_msg': {}, 'convert': {}}


class TypeException(Exception):
    """No function is registered for the type of an object that a program transforms or converts."""

    __module__ = 'tf2_ros.buffer_interface'  # the module of ROS 2, which tracebacks show


def provide(table: str, key: Key, function: Callable[..., Any]) -> None:
    """Register functions for every process that imports the package of `function`. This works only for packages of
    the underlay.
    """
    _provided[table][key] = function


def _own(table: str) -> dict[Key, Callable[..., Any]]:
    tables = current_process().state.setdefault('tf2_ros.buffer_interface', {})
    found: dict[Key, Callable[..., Any]] = tables.setdefault(table, {})
    return found


def _is_imported(function: Callable[..., Any]) -> bool:
    """Return whether the running program has imported the package of a provided function."""
    return bool(current_process().has_imported(function.__module__.partition('.')[0]))


def _find(table: str, key: Key) -> Callable[..., Any]:
    function = _own(table).get(key) or _provided[table].get(key)
    if function is None or (key not in _own(table) and not _is_imported(function)):
        raise TypeException(f'Type {key} is not loaded or supported')
    return function


class TransformRegistration:
    """The functions that transform stamped objects, by the exact type of the object."""

    def print_me(self) -> None:
        """Print the registered types and the names of their functions."""
        provided = {key: function for key, function in _provided['transform'].items() if _is_imported(function)}
        shown = {**provided, **_own('transform')}
        text = str({key: function.__name__ for key, function in shown.items()})
        current_process().write('stdout', f'{text}\n')

    def add(self, key: Key, callback: Callable[..., Any]) -> None:
        """Use `callback(object, TransformStamped)` for objects of type `key`."""
        _own('transform')[key] = callback

    def get(self, key: Key) -> Callable[..., Any]:
        """Return the function for a type.

        :raises TypeException: when no function is registered for the type.
        """
        return _find('transform', key)


class ConvertRegistration:
    """The functions that convert between types, directly or through a message type."""

    def add_from_msg(self, key: Key, callback: Callable[..., Any]) -> None:
        """Register `callback(message)`, which returns an object of type `key`."""
        _own('from_msg')[key] = callback

    def add_to_msg(self, key: Key, callback: Callable[..., Any]) -> None:
        """Register `callback(object)`, which returns a message for an object of type `key`."""
        _own('to_msg')[key] = callback

    def add_convert(self, key: Key, callback: Callable[..., Any]) -> None:
        """Register `callback(object)`, which converts directly. `key` is the pair (type of the object, type of the result)."""
        _own('convert')[key] = callback

    def get_from_msg(self, key: Key) -> Callable[..., Any]:
        """Return the function that :meth:`add_from_msg` has registered. Like the other getters, raise TypeException for an
        unknown type.
        """
        return _find('from_msg', key)

    def get_to_msg(self, key: Key) -> Callable[..., Any]:
        """Return the function that :meth:`add_to_msg` has registered."""
        return _find('to_msg', key)

    def get_convert(self, key: Key) -> Callable[..., Any]:
        """Return the function that :meth:`add_convert` has registered."""
        return _find('convert', key)


NO_WAIT = Duration()


class NotImplementedException(Exception):
    """The base class :class:`BufferInterface` was used for a lookup, which only its subclasses implement."""

    def __init__(self) -> None:
        super().__init__('CanTransform not implemented')


class BufferInterface:
    """Transforms stamped objects with the lookups of a subclass.

    Imports decide which types can be transformed: `import tf2_geometry_msgs` adds the stamped types of geometry_msgs.
    """

    def __init__(self) -> None:
        self.registration = TransformRegistration()

    def transform(self, object_stamped: Any, target_frame: str, timeout: Duration = NO_WAIT, new_type: Any = None) -> Any:
        """Return the object in another frame, at the time of its own stamp (0 means the latest time).

        :raises TypeException: when the object's type is not registered.
        :raises tf2.TransformException: one of its subclasses, when there is no transform.
        """
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        result = do_transform(object_stamped, self.lookup_transform(target_frame, header.frame_id, header.stamp, timeout))
        return convert(result, new_type) if new_type else result

    def transform_full(
        self,
        object_stamped: Any,
        target_frame: str,
        target_time: Any,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
        new_type: Any = None,
    ) -> Any:
        """Return the object in another frame at another time, through a fixed frame that does not move between these times."""
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        result = do_transform(
            object_stamped,
            self.lookup_transform_full(target_frame, target_time, header.frame_id, header.stamp, fixed_frame, timeout),
        )
        return convert(result, new_type) if new_type else result

    def lookup_transform(self, target_frame: str, source_frame: str, time: Any, timeout: Duration = NO_WAIT) -> Any:
        """Return a transform. Subclasses implement this method; the base class raises NotImplementedException."""
        raise NotImplementedException

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> Any:
        """Return a transform between two times. Subclasses implement this method; the base class raises
        NotImplementedException.
        """
        raise NotImplementedException

    def can_transform(self, target_frame: str, source_frame: str, time: Any, timeout: Duration = NO_WAIT) -> Any:
        """Return whether a lookup succeeds. Subclasses implement this method; the base class raises NotImplementedException."""
        raise NotImplementedException

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> Any:
        """Return whether :meth:`lookup_transform_full` succeeds. Subclasses implement this method; the base class raises
        NotImplementedException.
        """
        raise NotImplementedException


def Stamped(obj: Any, stamp: Any, frame_id: str) -> Any:  # noqa: N802
    """Set the header of an object, and return the object."""
    from std_msgs.msg import Header

    obj.header = Header(frame_id=frame_id, stamp=stamp)
    return obj


def convert(a: Any, b_type: Any) -> Any:
    """Return an object converted to another type, with a direct conversion if one is registered, and otherwise through a message.

    :raises TypeException: when no conversion is registered.
    """
    registration = ConvertRegistration()
    try:
        direct = registration.get_convert((type(a), b_type))
    except TypeException:
        if type(a) is b_type:
            return a
        return registration.get_from_msg(b_type)(registration.get_to_msg(type(a))(a))
    return direct(a)


__getattr__ = passed_on(__name__)
