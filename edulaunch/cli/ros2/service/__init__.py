"""`ros2 service`: one file per verb."""
