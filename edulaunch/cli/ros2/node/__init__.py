"""`ros2 node`: one file per verb."""
