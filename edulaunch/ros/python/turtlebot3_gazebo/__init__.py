"""turtlebot3_gazebo: a TurtleBot3 Waffle on an empty plane, in place of Gazebo."""
