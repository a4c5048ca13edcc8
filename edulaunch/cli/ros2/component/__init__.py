"""`ros2 component`: one file per verb."""
