"""The world of turtlesim: a canvas and the turtles on it."""

from __future__ import annotations

from operator import attrgetter
from random import Random

from edulaunch.engine.worlds.drawing import SIDE, DrawingLayer, as_float32
from edulaunch.engine.worlds.turtle import Turtle

PICTURES = ('ardent', 'bouncy', 'crystal', 'dashing', 'eloquent', 'foxy', 'galactic', 'humble', 'iron', 'rolling')
CENTER = as_float32(SIDE / 2.0)


class TurtleWorld:
    """Turtles on a square canvas with sides of :data:`SIDE` metres. They are updated in alphabetical order of their names.

    :param random: the generator that selects each turtle's picture, which is the only random value here.
    """

    def __init__(self, random: Random) -> None:
        self.turtles: list[Turtle] = []  # alphabetical
        self.drawing = DrawingLayer()
        self._random = random
        self._named = 0

    def find(self, name: str) -> Turtle | None:
        """Return the turtle with this `name`, or None if there is no such turtle."""
        for turtle in self.turtles:
            if turtle.name == name:
                return turtle
        return None

    def free_name(self) -> str:
        """Return the next automatic name: turtle1, turtle2, ... Numbers of removed turtles are not used again."""
        while True:
            self._named += 1
            name = f'turtle{self._named}'
            if self.find(name) is None:
                return name

    def spawn(self, x: float, y: float, theta: float, name: str = '') -> Turtle | None:
        """Create a turtle at (x, y, theta). If this is off the canvas, the first update moves the turtle to the edge.

        :param x: metres from the left edge of the canvas.
        :param y: metres from the bottom edge of the canvas; y points up.
        :param theta: radians, counter-clockwise from the x axis.
        :param name: the name of the turtle, or '' for an automatic name.
        :returns: the turtle, or None if the name is taken.
        """
        name = name or self.free_name()
        if self.find(name) is not None:
            return None
        turtle = Turtle(name, self.drawing, x, y, theta, self._random.randrange(len(PICTURES)))
        self.turtles.append(turtle)
        self.turtles.sort(key=attrgetter('name'))
        return turtle

    def spawn_first(self) -> Turtle:
        """Create turtle1 in the middle of an empty world, facing right."""
        turtle = self.spawn(CENTER, CENTER, 0.0)
        assert turtle is not None, 'an automatic name is never taken'
        return turtle

    def kill(self, name: str) -> bool:
        """Remove the turtle `name`; its lines stay. Return False for an unknown name."""
        turtle = self.find(name)
        if turtle is not None:
            self.turtles.remove(turtle)
        return turtle is not None

    def clear(self) -> None:
        """Delete the drawing; the turtles stay where they are."""
        self.drawing.clear()
        for turtle in self.turtles:
            turtle.pen.lift()

    def remove_all(self) -> None:
        """Remove all turtles, and start automatic names at turtle1 again; the drawing stays."""
        self.turtles.clear()
        self._named = 0

    def update(self, now_ns: int) -> None:
        """Simulate one tick of 16 ms for every turtle.

        :param now_ns: simulated time in ns, which decides which commands are too old.
        """
        for turtle in self.turtles:
            turtle.update(now_ns)
