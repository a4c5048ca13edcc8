"""`ros2` in a notebook: `%load_ext edulaunch`, then `%ros2 launch ...`, `%ros2 topic list` and so on.

Each notebook has one simulated machine. A launch starts a new machine, and later commands examine the programs that still run.
"""

from __future__ import annotations

from typing import Any


def load_ipython_extension(shell: Any) -> None:
    """Register the magics. IPython calls this function for `%load_ext edulaunch`."""
    from edulaunch.desk.notebook.hints import matcher, watch_names
    from edulaunch.desk.notebook.magics import RosMagics

    magics = RosMagics(shell)
    shell.register_magics(magics)
    shell.Completer.custom_matchers.append(matcher(magics.terminal))
    watch_names(shell)
