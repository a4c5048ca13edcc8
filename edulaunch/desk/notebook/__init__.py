"""`ros2` in a notebook: `%load_ext edulaunch`, then `%ros2 launch ...`, `%ros2 topic list` and so on.

One simulated machine runs behind the notebook. A launch starts it again, and later commands examine the programs that still run.
"""

from __future__ import annotations

from typing import Any


def load_ipython_extension(shell: Any) -> None:
    """Register the magics; `%load_ext edulaunch` calls this."""
    from edulaunch.desk.notebook.hints import matcher, watch_names
    from edulaunch.desk.notebook.magics import RosMagics

    magics = RosMagics(shell)
    shell.register_magics(magics)
    shell.Completer.custom_matchers.append(matcher(magics.terminal))
    watch_names(shell)
