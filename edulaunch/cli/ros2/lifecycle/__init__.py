"""`ros2 lifecycle`: one file per verb."""
