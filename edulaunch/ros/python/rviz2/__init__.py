"""rviz2 without a window: it reads its config, joins tf as RViz does, and leaves pictures to a recording."""
