"""`ros2 pkg`: one file per verb."""
