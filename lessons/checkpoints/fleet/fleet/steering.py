from math import atan2, hypot

from geometry_msgs.msg import Twist


def steer(x, y):
    """Return the command that drives a turtle to a point that it sees at (x, y)."""
    command = Twist()
    command.linear.x = 1.5 * hypot(x, y)
    command.angular.z = 4.0 * atan2(y, x)
    return command
