"""`ros2` in a notebook: `%load_ext edulaunch.jupyter`, then `%ros2 launch ...`, `%ros2 topic list` and so on.

One simulated machine lives behind the notebook: a launch starts it anew, the commands after it look at what still runs there.
"""

from __future__ import annotations

from typing import Any


def load_ipython_extension(shell: Any) -> None:
    """What `%load_ext edulaunch.jupyter` calls."""
    from edulaunch.jupyter.hints import matcher, watch_names
    from edulaunch.jupyter.magics import RosMagics

    magics = RosMagics(shell)
    shell.register_magics(magics)
    shell.Completer.custom_matchers.append(matcher(magics.terminal))
    watch_names(shell)
