"""What the command `ros2 launch` does."""
