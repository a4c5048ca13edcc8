"""`ros2 interface`: one file per verb."""
