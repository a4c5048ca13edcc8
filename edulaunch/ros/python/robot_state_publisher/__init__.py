"""robot_state_publisher: The frames of a robot, from its description and the positions of its joints."""
