"""What an executable of a package is, before anything runs."""

from __future__ import annotations

from typing import NamedTuple


class Program(NamedTuple):
    """A program of a package; all but native ones run in the simulation.

    :param kind: 'entry_point' (a function of a module), 'script' (a file run as `__main__`), 'module' (of `python3 -m`), 'shell'
        (`file` is a line of commands), or one that ends at once and says why: 'native' (built from C++: `file` is the line of
        CMakeLists.txt that builds it) or 'absent' (of a package that is not here: `file` is what it belongs to).
    :param path: `<prefix>/lib/<package>/<executable>`, the word that stands in a command line.
    :param module: dotted module name of an entry point, else ''.
    :param function: name of the entry point's function, else ''.
    :param file: the script as the student wrote it (never a generated link), else ''.
    :param python_roots: folders from which this program's own modules are imported, first match wins.
    """

    kind: str
    package: str
    executable: str
    path: str
    module: str = ''
    function: str = ''
    file: str = ''
    python_roots: tuple[str, ...] = ()
