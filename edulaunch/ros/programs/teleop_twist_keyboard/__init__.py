"""teleop_twist_keyboard: Drives a robot with the keys of a terminal."""
