"""The implementation of the command `ros2 launch`."""
