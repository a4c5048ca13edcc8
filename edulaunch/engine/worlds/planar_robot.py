"""A differential-drive robot in the plane."""

from __future__ import annotations

from math import cos, inf, pi, sin


class PlanarRobot:
    """A robot that drives with a linear and an angular velocity, like a TurtleBot3 Waffle.

    Position (metres) and `theta` (radians, counter-clockwise from x, in [-pi, pi)) are in the world frame. The last command
    stays valid, however old it is. The robot has no mass, so a new velocity applies immediately. Between commands, the robot
    moves along an exact circular arc, so the result does not depend on the number of calls.

    :param max_linear: limit of the linear velocity in both directions, m/s (0.26 for the Waffle).
    :param max_angular: limit of the angular velocity in both directions, rad/s (1.82 for the Waffle).
    """

    __slots__ = ('x', 'y', 'theta', 'linear', 'angular', 'time_ns', 'max_linear', 'max_angular')

    def __init__(
        self,
        x: float = 0.0,
        y: float = 0.0,
        theta: float = 0.0,
        time_ns: int = 0,
        *,
        max_linear: float = 0.26,
        max_angular: float = 1.82,
    ) -> None:
        self.x = x
        self.y = y
        self.theta = _wrapped(theta)
        self.linear = 0.0
        self.angular = 0.0
        self.time_ns = time_ns
        self.max_linear = max_linear
        self.max_angular = max_angular

    def command(self, linear: float, angular: float, now_ns: int) -> None:
        """Drive with these velocities from `now_ns`, each limited to its maximum; nan means zero.

        :param linear: m/s along the robot's x axis.
        :param angular: rad/s, counter-clockwise.
        :param now_ns: simulated time in ns.
        """
        self.advance_to(now_ns)
        self.linear = _limited(linear, self.max_linear)
        self.angular = _limited(angular, self.max_angular)

    def advance_to(self, now_ns: int) -> None:
        """Simulate up to the time `now_ns`. A time before the last simulated time has no effect."""
        dt = (now_ns - self.time_ns) * 1e-9
        if dt <= 0.0:
            return
        self.time_ns = now_ns
        half_turn = 0.5 * self.angular * dt
        chord = self.linear * dt * (sin(half_turn) / half_turn if half_turn else 1.0)
        self.x += chord * cos(self.theta + half_turn)
        self.y += chord * sin(self.theta + half_turn)
        self.theta = _wrapped(self.theta + 2.0 * half_turn)


def _limited(value: float, limit: float) -> float:
    return max(-limit, min(limit, value)) if -inf <= value <= inf else 0.0


def _wrapped(angle: float) -> float:
    return (angle + pi) % (2.0 * pi) - pi if not -pi <= angle < pi else angle
