"""The magics for IPython. They call :class:`~edulaunch.desk.notebook.terminal.CellTerminal`."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Callable
from contextlib import redirect_stderr
from typing import Any

from IPython.core.magic import Magics, line_cell_magic, line_magic, magics_class, no_var_expand

from edulaunch.desk.notebook.terminal import CellTerminal
from edulaunch.engine.recording import Recording


@magics_class
class RosMagics(Magics):
    """The magics `%ros2`, `%source`, `%recording` and others."""

    def __init__(self, shell: Any) -> None:
        super().__init__(shell)
        self._printed: list[str] = []
        self.terminal = CellTerminal(lambda stream, text: self._printed.append(text))
        self.terminal.machine.show_keyboard = _show_keyboard

    @no_var_expand
    @line_cell_magic
    def ros2(self, line: str, cell: str | None = None) -> Any:
        """Run `ros2` on the simulated machine. `%%ros2` runs several commands, one on each line, and returns the last Recording::

        %ros2 launch PACKAGE FILE name:=value --for 20     start a new machine, run 20 simulated seconds, return the Recording
        %ros2 topic list                                   run any other command, together with the programs that still run
        %ros2 topic echo /turtle1/pose --for 2             press Ctrl-C after 2 simulated seconds
        %ros2 run turtlesim draw_square &                  run it in the background; buttons appear for a program that reads keys
        %ros2 view frames                                  show the live view with its tab Frames; time passes while it is visible
        %ros2 jobs      %ros2 stop      %ros2 wait 5       list jobs, end them, let simulated seconds pass

        With --quiet, a launch or a run shows only errors. The Tab key completes words. `ros2` receives brackets and dollar signs
        unchanged.
        """
        return self._printing(lambda: self.terminal.ros2(line) if cell is None else self.terminal.several(line, cell))

    @no_var_expand
    @line_magic
    def source(self, line: str) -> None:
        """Use the packages of a workspace: `%source my_ws` or, as in a shell, `%source my_ws/install/setup.bash`."""
        self._printing(lambda: self.terminal.source(line.strip().strip('\'"')))

    @no_var_expand
    @line_magic
    def colcon(self, line: str) -> None:
        """Explain which parts of `colcon build` are not needed here."""
        self._printing(lambda: self.terminal.set_up(f'colcon {line}'))

    @no_var_expand
    @line_magic
    def rosdep(self, line: str) -> None:
        """Explain which parts of `rosdep` are not needed here."""
        self._printing(lambda: self.terminal.set_up(f'rosdep {line}'))

    @no_var_expand
    @line_magic
    def apt(self, line: str) -> None:
        """Explain which packages of `apt install ros-jazzy-...` are already available."""
        self._printing(lambda: self.terminal.set_up(f'apt {line}'))

    @no_var_expand
    @line_magic
    def edulaunch(self, line: str) -> None:
        """Run the command `edulaunch`, as in a terminal: `%edulaunch doctor FILE`, `%edulaunch pkg check DIR`."""
        from edulaunch.desk.cli.main import main

        with redirect_stderr(sys.stdout):
            try:
                main(shlex.split(line))
            except SystemExit:  # argparse has printed the reason
                pass
            except ValueError as error:
                print(f'error: {error}: add the missing quotation mark')

    @line_magic
    def recording(self, line: str) -> Recording:
        """Return the Recording of the simulated machine from its start until now."""
        found: Recording = self._printing(self.terminal.recording)
        return found

    def _printing(self, action: Callable[[], Any]) -> Any:
        """Call a function.

        Then print its collected output at once, so that a cell has the same single output on every computer.
        """
        try:
            return action()
        finally:
            sys.stdout.write(''.join(self._printed))
            self._printed.clear()


def _show_keyboard(press: Callable[[str], str], title: str) -> None:
    """Show a keyboard widget, or print a line if ipywidgets is not installed."""
    import IPython.display as front_end

    display: Any = front_end.display
    try:
        from edulaunch.desk.notebook.interact import keyboard

        display(keyboard(press, title))
    except ImportError:
        sys.stdout.write(
            f'{title} reads the keyboard\n  help: type pip install ipywidgets to get buttons here, or run it in a terminal\n'
        )
