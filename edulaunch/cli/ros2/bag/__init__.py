"""`ros2 bag`: one file per verb."""
