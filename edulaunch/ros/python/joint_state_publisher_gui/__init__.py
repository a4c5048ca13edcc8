"""joint_state_publisher_gui: The same as joint_state_publisher, without a window."""
