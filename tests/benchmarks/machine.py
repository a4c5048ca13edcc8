"""The shared machine beside what a person at a terminal feels: `python benchmarks/machine.py`. Takes half a minute.

Measured in processes and terminals of their own, on whatever else the computer does meanwhile; the figure is the best of some
rounds, the median stands beside it.
"""

from __future__ import annotations

import os
import pty
import select
import shlex
import signal
import subprocess
import sys
import tempfile
import time
from statistics import median

from edulaunch.desk.machine.place import installation

ROS2 = [sys.executable, '-c', 'import sys; from edulaunch.desk.machine.command import ros2; sys.exit(ros2())']
UP = b'\x1b[A'


class Terminal:
    """A command in a pty."""

    def __init__(self, line: str, env: dict[str, str]) -> None:
        self.began_s = time.perf_counter()
        self.pid, self.number = pty.fork()
        if self.pid == 0:
            os.execve(ROS2[0], [*ROS2, *shlex.split(line)], env)
        self.output = b''

    def until(self, text: bytes, count: int = 1, seconds: float = 20.0) -> float:
        """When the text had come so many times, in seconds since the start."""
        end_s = time.perf_counter() + seconds
        while self.output.count(text) < count:
            ready, _, _ = select.select([self.number], [], [], max(0.0, end_s - time.perf_counter()))
            if not ready:
                raise TimeoutError(self.output.decode())
            self.output += os.read(self.number, 1 << 16)
        return time.perf_counter() - self.began_s

    def close(self) -> None:
        """Close the window."""
        os.kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)
        os.close(self.number)


def tell(what: str, values: list[float], limit: float, unit: str = 's') -> None:
    """One line of figures."""
    print(f'{what:<58} {min(values):8.3f} {unit:<3} (median {median(values):.3f}; wanted: under {limit:g} {unit})')


def first_launch(env: dict[str, str]) -> float:
    """From the first command of all to the first line of its launch."""
    with tempfile.TemporaryDirectory() as place:
        launch = Terminal('launch turtlesim multisim.launch.py', {**env, 'XDG_RUNTIME_DIR': place, 'EDULAUNCH_GRACE_S': '1'})
        seconds = launch.until(b'[INFO] [launch]')
        launch.until(b'[turtlesim_node-2]: process started')
        launch.close()
        stop(place)
    return seconds


def whole_command(env: dict[str, str]) -> float:
    """`ros2 topic list`, from start to end of the process."""
    began_s = time.perf_counter()
    subprocess.run([*ROS2, 'topic', 'list'], env=env, check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - began_s


def key_presses(env: dict[str, str]) -> list[float]:
    """From an arrow key in one terminal to the command's text in another."""
    teleop, echo = Terminal('run turtlesim turtle_teleop_key', env), Terminal('topic echo /turtle1/cmd_vel', env)
    teleop.until(b"'Q' to quit.")
    while b'linear' not in echo.output:
        os.write(teleop.number, UP)
        if select.select([echo.number], [], [], 0.2)[0]:
            echo.output += os.read(echo.number, 1 << 16)
    found = []
    for _ in range(20):
        while select.select([echo.number], [], [], 0.2)[0]:
            echo.output += os.read(echo.number, 1 << 16)
        count, began_s = echo.output.count(b'---'), time.perf_counter()
        os.write(teleop.number, UP)
        echo.until(b'---', count + 1)
        found.append(time.perf_counter() - began_s)
    teleop.close()
    echo.close()
    return found


def lost_messages(env: dict[str, str], messages: int = 600) -> int:
    """How many of the pose messages, 62.5 a second, do not come out of `ros2 topic echo`."""
    drive = Terminal('topic pub -r 20 /turtle1/cmd_vel geometry_msgs/msg/Twist "{angular: {z: 0.1}}"', env)
    drive.until(b'publishing #3')
    echo = Terminal('topic echo /turtle1/pose --field theta', env)
    echo.until(b'---', messages)
    values = [float(text) for text in echo.output.decode().split('---')[1:messages] if text.strip()]
    echo.close()
    drive.close()
    steps = [(after - before) % 6.283185307 for before, after in zip(values, values[1:], strict=False)]
    usual = median(steps)
    return sum(round(step / usual) - 1 for step in steps)


def idle_share(pid: int, seconds: float = 5.0) -> float:
    """Share of a core that the machine uses while nothing runs on it but what is connected."""

    def used_s() -> float:
        with open(f'/proc/{pid}/stat') as file:
            fields = file.read().rpartition(')')[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')

    before_s = used_s()
    time.sleep(seconds)
    return (used_s() - before_s) / seconds * 100


def stop(place: str) -> int:
    """Stop the machine of a place; returns its pid."""
    with open(os.path.join(place, f'edulaunch-{installation()}', 'domain-0')) as file:
        pid = int(file.read().split('\n')[3])
    os.kill(pid, signal.SIGTERM)
    return pid


def main() -> None:
    """Measure everything."""
    env = dict(os.environ)
    tell('first command of all: first line of its launch', [first_launch(env) for _ in range(5)], 0.6)
    with tempfile.TemporaryDirectory() as place:
        env['XDG_RUNTIME_DIR'] = place
        idle = Terminal('topic echo /nothing std_msgs/msg/String', env)
        while not os.path.exists(os.path.join(place, f'edulaunch-{installation()}', 'domain-0')):
            time.sleep(0.01)
        with open(os.path.join(place, f'edulaunch-{installation()}', 'domain-0')) as file:
            pid = int(file.read().split('\n')[3])
        time.sleep(2.0)
        tell('a machine on which nothing happens', [idle_share(pid)], 1, '%')
        sim = Terminal('run turtlesim turtlesim_node', env)
        sim.until(b'Spawning turtle')
        tell('ros2 topic list, the whole process', [whole_command(env) for _ in range(20)], 0.1)
        tell('arrow key to the text in another terminal', key_presses(env), 0.05)
        print(f'{"ros2 topic echo at 62.5 Hz: messages lost of 600":<58} {lost_messages(env):8d}')
        for terminal in (sim, idle):
            terminal.close()
        stop(place)


if __name__ == '__main__':
    main()
