"""`ros2 param`: one file per verb."""
