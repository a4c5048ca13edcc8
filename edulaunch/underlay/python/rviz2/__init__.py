"""rviz2 without a window: it reads its config, joins tf as RViz does, and leaves the picture to the recording."""
