"""Parameter files that launch generates. Command lines name these files, but they are on the disk only while a real program
may read them.
"""

from __future__ import annotations

import math
import os
import re
import weakref
from typing import TYPE_CHECKING, Any

from edulaunch.engine.graph.parameter_files import PARAMETERS_KEY, Entry, read_parameter_file

if TYPE_CHECKING:
    from collections.abc import Mapping

# Text that YAML writes without quotes on one line, and reads as a string.
_WORD = re.compile(r'[A-Za-z_/](?:[A-Za-z0-9_/.*-]|[A-Za-z0-9_/.*-] (?=[A-Za-z0-9_/.*-])){0,59}')
_MEANINGS = frozenset(('true', 'false', 'yes', 'no', 'on', 'off', 'null', 'y', 'n', 'nan', 'inf', 'infinity'))
_LARGEST = 2**63
_PATHS = 'launch_ros.parameter_files'


class GeneratedFile:
    """A file with a name. Simulated programs receive its content, and real programs read it from the disk.

    :param path: the path of the file on command lines; see :func:`temporary_path`.
    """

    def __init__(self, path: str, text: str = '') -> None:
        self.path = path
        self._text = text

    _inode: int | None = None

    @property
    def text(self) -> str:
        """The content of the file as a string."""
        return self._text

    @property
    def content(self) -> Any:
        """The content of the file as YAML data."""
        import yaml

        return yaml.safe_load(self.text)

    def entries(self) -> list[Entry]:
        """Return the parameters in the file, as rcl reads them.

        :raises ParameterFileError: for content that rcl rejects.
        """
        return read_parameter_file(self.text)

    def write(self) -> None:
        """Write the file to the disk in one step. The file exists until :meth:`remove` is called, this object is deleted, or
        Python ends.
        """
        if self._inode is not None:
            return
        import tempfile

        handle, draft = tempfile.mkstemp(prefix='launch_params_')
        with open(handle, 'w', encoding='utf-8') as stream:
            stream.write(self.text)
        os.replace(draft, self.path)
        self._inode = os.stat(self.path).st_ino
        weakref.finalize(self, _remove, self.path, self._inode)

    def remove(self) -> None:
        """Delete the file, if it exists."""
        if self._inode is not None:
            _remove(self.path, self._inode)
            self._inode = None


class GeneratedParameters(GeneratedFile):
    """The file of one dictionary of parameters.

    :param node_key: the key above the values: the full name of the node, or `/**`.
    """

    def __init__(self, path: str, node_key: str, values: Mapping[str, Any]) -> None:
        self.path = path
        self._node_key = node_key
        self._values = values

    @property
    def content(self) -> dict[str, Any]:
        """The content of the file as YAML data."""
        plain = {name: list(value) if isinstance(value, tuple) else value for name, value in self._values.items()}
        return {self._node_key: {PARAMETERS_KEY: plain}}

    @property
    def text(self) -> str:
        """The parameters as a YAML string."""
        import yaml

        dumper: Any = getattr(yaml, 'CSafeDumper', yaml.SafeDumper)
        text: str = yaml.dump(self.content, Dumper=dumper, default_flow_style=False, allow_unicode=True)
        return text

    def entries(self) -> list[Entry]:
        """Return the parameters in the file. The parameters are converted to YAML and parsed only if the conversion could
        change a value.
        """
        entries: list[Entry] = []
        line = 3
        for name in sorted(self._values):
            value = self._values[name]
            items = value if isinstance(value, (list, tuple)) else (value,)
            if not items or not _is_word(name) or not all(map(_is_kept, items)):
                return super().entries()
            is_list = items is value
            entries.append(Entry(self._node_key, name, list(items) if is_list else value, line + is_list))
            line += 1 + is_list * len(items)
        return entries if entries else super().entries()


def _is_kept(value: Any) -> bool:
    """Return whether rcl reads exactly this value from YAML's text for it."""
    kind = type(value)
    if kind is str:
        return _is_word(value)
    return kind is bool or (kind is int and -_LARGEST <= value < _LARGEST) or (kind is float and math.isfinite(value))


def _is_word(text: str) -> bool:
    return _WORD.fullmatch(text) is not None and text.lower() not in _MEANINGS


def temporary_path(key: str, state: dict[str, Any]) -> str:
    """Return the path `launch_params_XXXXXXXX` in the temporary folder.

    The name depends on `key`, so that command lines, which are recorded, are the same in each run. Two keys of one launch never
    have the same path.

    :param state: the state of the process that runs launch.
    """
    import zlib

    folder, keys = state.get(_PATHS) or _first_paths(state)
    digest = zlib.crc32(key.replace(folder, '').encode())  # the folder of workspaces differs on each machine
    while keys.setdefault(digest, key) != key:
        digest = zlib.crc32(b'another', digest)
    return f'{folder}{os.sep}launch_params_{digest:08x}'


def _first_paths(state: dict[str, Any]) -> tuple[str, dict[int, str]]:
    import tempfile

    paths: tuple[str, dict[int, str]] = tempfile.gettempdir(), {}
    state[_PATHS] = paths
    return paths


def _remove(path: str, inode: int) -> None:
    """Remove the file if it is still the one that was written. Another run may have written its own file with the same name."""
    try:
        if os.stat(path).st_ino == inode:
            os.unlink(path)
    except OSError:
        return  # the file does not exist any more
