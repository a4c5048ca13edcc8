"""`ros2 action`: one file per verb."""
