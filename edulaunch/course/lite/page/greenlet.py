"""`greenlet` in Pyodide, as far as edulaunch needs it: tasks that switch by suspending WebAssembly (JSPI).

Each greenlet is a separate call from JavaScript. A switch resolves the promise of the next greenlet and waits for the
promise of the current greenlet. The browser's queue of promises then continues with the next greenlet. A greenlet that is
never switched to again stays suspended, and no exception is raised in it.
"""

from __future__ import annotations

from pyodide.code import run_js
from pyodide.ffi import create_proxy, run_sync

_change, _open, _prepare = run_js("""(() => {
    const doors = new Map();
    const open = (number) => { const door = doors.get(number); doors.delete(number); door(); };
    const change = (mine, other) => new Promise((door) => { doors.set(mine, door); open(other); });
    const begin = (body) => Promise.resolve().then(() => body.callPromising()).finally(() => body.destroy());
    return [change, open, (number, body) => { doors.set(number, () => { begin(body); }); }];
})()""")


class GreenletExit(BaseException):
    """The exception that ends a greenlet without a traceback."""


class greenlet:
    """A call that can be suspended and continued."""

    count = 0
    dead = False
    gr_frame = None

    def __init__(self, run=None, parent=None):
        self.run = run
        self.parent = _current if parent is None else parent
        self._value = None
        self._error = None
        greenlet.count += 1
        self._number = greenlet.count
        if run is not None:
            _prepare(self._number, create_proxy(self._body))

    def switch(self, *values):
        """Continue this greenlet. Return the value of the next switch back, or raise the exception that ended a child."""
        global _current
        mine = _current
        if self is mine:
            return values[0] if len(values) == 1 else values
        self._value = values[0] if len(values) == 1 else values
        run_sync(_change(mine._number, self._number))
        _current = mine
        error, mine._error = mine._error, None
        if error is not None:
            raise error
        return mine._value

    def _body(self):
        global _current
        _current = self
        try:
            value, error = self.run(), None
        except GreenletExit as end:
            value, error = end, None
        except BaseException as raised:
            value, error = None, raised
        self.dead, self.run = True, None
        self.parent._value, self.parent._error = value, error
        _open(self.parent._number)


_current = None
_current = greenlet()


def getcurrent():
    """Return the running greenlet."""
    return _current
