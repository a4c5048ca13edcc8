"""`ros2 topic`: one file per verb."""
