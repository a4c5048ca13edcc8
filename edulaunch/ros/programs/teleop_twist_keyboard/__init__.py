"""teleop_twist_keyboard: A program that drives a robot with the keys of a terminal."""
