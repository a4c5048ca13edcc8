"""joint_state_publisher: Positions for all joints of a robot, as long as nothing else knows them."""
