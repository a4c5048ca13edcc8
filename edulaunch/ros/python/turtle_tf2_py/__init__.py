"""turtle_tf2_py: turtles as tf frames, and a turtle that follows a frame."""
