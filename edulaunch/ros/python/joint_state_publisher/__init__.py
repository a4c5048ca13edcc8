"""joint_state_publisher: Positions for all joints of a robot, while no other program provides them."""
