"""turtlesim: turtles that draw on a canvas, the first robot of every ROS course."""
