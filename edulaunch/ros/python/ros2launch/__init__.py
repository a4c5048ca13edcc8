"""The work of the command `ros2 launch`."""
