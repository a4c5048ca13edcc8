"""The magics: thin words around :class:`~edulaunch.jupyter.terminal.Terminal`."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Callable
from contextlib import redirect_stderr
from typing import Any

from IPython.core.magic import Magics, line_cell_magic, line_magic, magics_class, no_var_expand

from edulaunch.engine.recording import Recording
from edulaunch.jupyter.terminal import Terminal


@magics_class
class RosMagics(Magics):
    """`%ros2`, `%source` and `%recording`."""

    def __init__(self, shell: Any) -> None:
        super().__init__(shell)
        self._printed: list[str] = []
        self.terminal = Terminal(lambda stream, text: self._printed.append(text))
        self.terminal.machine.show_keyboard = _show_keyboard

    @no_var_expand
    @line_cell_magic
    def ros2(self, line: str, cell: str | None = None) -> Any:
        """The `ros2` command on the simulated machine. `%%ros2` takes several, one on each line; the last Recording is returned.

        %ros2 launch PACKAGE FILE name:=value --for 20     start anew, run 20 simulated seconds; returns the Recording
        %ros2 topic list                                   any other command, beside what still runs
        %ros2 topic echo /turtle1/pose --for 2             press Ctrl-C after 2 simulated seconds
        %ros2 run turtlesim draw_square &                  leave it running; a program that reads keys gets buttons
        %ros2 view frames                                  the live desk, here with its tf frames; time goes on while it is seen
        %ros2 jobs      %ros2 stop      %ros2 wait 5       what was left running; end it; let simulated seconds pass

        --quiet behind a launch or a run shows errors only. Tab completes. Brackets and dollar signs are passed on as they are.
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
        """Says what of `colcon build` is not needed here."""
        self._printing(lambda: self.terminal.set_up(f'colcon {line}'))

    @no_var_expand
    @line_magic
    def rosdep(self, line: str) -> None:
        """Says what of `rosdep install` is not needed here."""
        self._printing(lambda: self.terminal.set_up(f'rosdep {line}'))

    @no_var_expand
    @line_magic
    def apt(self, line: str) -> None:
        """Says what of `apt install ros-jazzy-...` is here already."""
        self._printing(lambda: self.terminal.set_up(f'apt {line}'))

    @no_var_expand
    @line_magic
    def edulaunch(self, line: str) -> None:
        """The command `edulaunch`, as in a terminal: `%edulaunch doctor FILE`, `%edulaunch pkg check DIR`."""
        from edulaunch.desk.cli.main import main

        with redirect_stderr(sys.stdout):
            try:
                main(shlex.split(line))
            except SystemExit:  # argparse has said why
                pass
            except ValueError as error:
                print(f'error: {error}: a quote is not closed')

    @line_magic
    def recording(self, line: str) -> Recording:
        """The Recording of the simulated machine from its start until now."""
        found: Recording = self._printing(self.terminal.recording)
        return found

    def _printing(self, action: Callable[[], Any]) -> Any:
        """Print what it said in one piece: both streams in order, one output in the cell whatever the machine's speed."""
        try:
            return action()
        finally:
            sys.stdout.write(''.join(self._printed))
            self._printed.clear()


def _show_keyboard(press: Callable[[str], str], title: str) -> None:
    """Show buttons, where the front end has any."""
    import IPython.display as front_end

    display: Any = front_end.display
    try:
        from edulaunch.jupyter.interact import keyboard

        display(keyboard(press, title))
    except ImportError:
        sys.stdout.write(f'{title} reads the keyboard\n  help: pip install ipywidgets gives it buttons; or use a terminal\n')
