"""One turtle: its motion, drawing and colour sensor in one tick, and its rotation for the action rotate_absolute."""

from __future__ import annotations

from math import cos, floor, hypot, nan, sin

from edulaunch.engine.worlds.drawing import SIDE, UNTOUCHED, Color, DrawingLayer, Pen, as_float32

PI = 3.14159265  # turtlesim's own pi; the missing digits decide which way 3.1416 turns
TWO_PI = 2.0 * PI
CLOSE_ENOUGH = 0.02


def normalize(angle: float) -> float:
    """Return the angle in [-PI, PI) radians that is equivalent to `angle`. For infinity and nan, return nan."""
    try:
        return angle - TWO_PI * floor((angle + PI) / TWO_PI)
    except (OverflowError, ValueError):
        return nan


def normalize_single(angle: float) -> float:
    """Normalize `angle` (radians) as :func:`normalize` does, rounded to 32 bits."""
    return as_float32(normalize(angle))


class RotationGoal:
    """A rotation to the absolute heading `theta` (radians), started at the heading `start`.

    `remaining` is the feedback, and `delta` is the result. `delta` is the start heading minus the current heading, which is
    negative after a left turn.
    """

    __slots__ = ('theta', 'start', 'remaining', 'delta')

    def __init__(self, theta: float, start: float) -> None:
        self.theta = normalize_single(theta)
        self.start = as_float32(start)
        self.remaining = 0.0
        self.delta = 0.0

    def step(self, heading: float) -> float:
        """Return the angular velocity (rad/s) for the rotation at the current `heading` (radians), or 0.0 at the goal."""
        heading = as_float32(heading)
        self.remaining = normalize_single(as_float32(self.theta - heading))
        self.delta = normalize_single(as_float32(self.start - heading))
        if abs(normalize_single(as_float32(heading - self.theta))) < CLOSE_ENOUGH:
            return 0.0
        return -1.0 if self.remaining < 0.0 else 1.0


STEP_S = 0.001 * 16
COMMAND_LASTS_NS = 1_000_000_000


class Turtle:
    """A turtle on the canvas.

    Positions are in metres: `x` from the left edge, `down` from the top edge, and :attr:`y` from the bottom edge. `theta` is in
    radians, counter-clockwise from the x axis. Velocities are in the turtle's own frame, in m/s and rad/s.

    Each :meth:`update` sets these attributes. `color` is the value of the colour sensor. `wall_hit` is the position (x, down)
    outside the canvas where a wall stopped the turtle, or None. `turned` states whether the turtle has reached a rotation goal.
    `still` states whether the turtle had no velocity and did not move.
    """

    __slots__ = (
        'name',
        'picture',
        'pen',
        'x',
        'down',
        'theta',
        'speed',
        'sideways',
        'turning',
        'command_ns',
        'rotation',
        'color',
        'wall_hit',
        'turned',
        'still',
        '_layer',
        '_seen',
        '_requests',
        '_moved',
    )

    def __init__(self, name: str, layer: DrawingLayer, x: float, y: float, theta: float, picture: int = 0) -> None:
        self.name = name
        self.picture = picture
        self.pen = Pen()
        self.x = as_float32(x)
        self.down = as_float32(SIDE - as_float32(y))
        self.theta = as_float32(theta)
        self.speed = self.sideways = self.turning = 0.0
        self.command_ns = 0
        self.rotation: RotationGoal | None = None
        self.color = UNTOUCHED
        self.wall_hit: tuple[float, float] | None = None
        self.turned = False
        self.still = False
        self._layer = layer
        self._seen = -1  # version of the layer when the colour was last read
        self._requests: list[tuple[bool, float, float, float]] = []
        self._moved = True  # whether it moved in the last tick; a resting turtle needs no computation

    @property
    def y(self) -> float:
        """The distance from the bottom edge in metres."""
        return SIDE - self.down

    @property
    def linear_velocity(self) -> float:
        """The magnitude of the velocity in m/s. It is never negative, even if the turtle drives backward."""
        return hypot(self.speed, self.sideways) if self.sideways else abs(self.speed)

    def command(self, linear: float, angular: float, now_ns: int, sideways: float | None = None) -> None:
        """Move with these velocities for one second, or until the next command.

        :param linear: m/s along the turtle's x axis.
        :param angular: rad/s, counter-clockwise.
        :param sideways: m/s along the turtle's y axis, or None to leave this velocity unchanged.
        :param now_ns: simulated time in ns.
        """
        self.command_ns = now_ns
        self.speed = linear
        self.turning = angular
        if sideways is not None:
            self.sideways = sideways

    def set_pen(self, color: Color, width: int, off: bool) -> None:
        """Set the pen.

        :param color: red, green and blue from 0 to 255.
        :param width: the width in pixels of the window.
        :param off: whether to lift the current pen, without changing its colour and width.
        """
        if off:
            self.pen.on = False
        else:
            self.pen = Pen(color, width)

    def teleport_absolute(self, x: float, y: float, theta: float) -> None:
        """Move to (`x`, `y`, `theta`), in metres and radians, in the next update. A y above the top edge is replaced by the
        top edge.
        """
        self._requests.append((True, x, y, theta))

    def teleport_relative(self, linear: float, angular: float) -> None:
        """Turn by `angular` (radians) and then jump `linear` metres ahead, in the next update."""
        self._requests.append((False, linear, 0.0, angular))

    def rotate_to(self, theta: float) -> RotationGoal:
        """Rotate on the spot until the heading is `theta` (radians). The new goal replaces an earlier goal."""
        self.rotation = RotationGoal(theta, self.theta)
        return self.rotation

    def stop(self) -> None:
        """Set all velocities to zero."""
        self.speed = self.sideways = self.turning = 0.0

    def update(self, now_ns: int) -> None:
        """Simulate one tick of 16 ms at `now_ns`: teleports, rotation, timeout, motion, walls, colour, pen, in this order."""
        if self._requests:
            self._teleport()
        if self.rotation is not None:
            self._rotate(self.rotation, now_ns)
        if now_ns - self.command_ns > COMMAND_LASTS_NS:
            self.speed = self.sideways = self.turning = 0.0
        if self.speed or self.turning or self.sideways or self._moved:
            self.still = False
            self._move()
            return
        self.still = True
        if self._seen != self._layer.version:
            self.color = self._layer.color_at(self.x, self.down)
            self._seen = self._layer.version

    def _move(self) -> None:
        speed = self.speed
        theta = self.theta + self.turning * STEP_S
        if not -PI <= theta < PI:
            theta = normalize(theta)
        old_x, old_down = self.x, self.down
        c, s = cos(theta), sin(theta)
        x = old_x + c * speed * STEP_S
        down = old_down - s * speed * STEP_S
        if self.sideways:
            x = old_x + (c * speed * STEP_S - s * self.sideways * STEP_S)
            down = old_down - (c * self.sideways * STEP_S + s * speed * STEP_S)
        self.wall_hit = None
        if x < 0.0 or x > SIDE or down < 0.0 or down > SIDE:
            self.wall_hit = (x, down)
            x = min(max(x, 0.0), SIDE)
            down = min(max(down, 0.0), SIDE)
        moved = x != old_x or down != old_down
        self._moved = moved or theta != self.theta or self.wall_hit is not None
        self.theta = theta
        self.x = x
        self.down = down
        layer = self._layer
        if moved:
            self._seen = layer.version
            if self.pen.on:
                self.color = layer.trace(self.pen, old_x, old_down, x, down)
            else:
                self.color = layer.color_at(x, down)
        elif self._seen != layer.version:
            self.color = layer.color_at(x, down)
            self._seen = layer.version

    def _rotate(self, goal: RotationGoal, now_ns: int) -> None:
        self.speed = self.sideways = 0.0
        self.turning = goal.step(self.theta)
        self.turned = self.turning == 0.0
        if self.turned:
            self.rotation = None
        else:
            self.command_ns = now_ns

    def _teleport(self) -> None:
        for absolute, x, y, theta in self._requests:
            old_x, old_down = self.x, self.down
            if absolute:
                self.x, self.down, self.theta = x, max(0.0, SIDE - y), theta
            else:
                self.theta += theta
                self.x += cos(self.theta) * x
                self.down -= sin(self.theta) * x
            if self.pen.on:
                self._layer.draw(self.pen, old_x, old_down, self.x, self.down)
        self._requests.clear()
        self._moved = True
        self._seen = -1
