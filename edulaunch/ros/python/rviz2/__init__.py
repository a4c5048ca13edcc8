"""rviz2 without a window: it reads its config and receives tf as RViz does. Recordings draw the pictures."""
