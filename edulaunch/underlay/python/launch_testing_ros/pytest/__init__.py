"""Launch tests of ROS nodes in pytest."""
