"""joint_state_publisher_gui: Without a window: the same as joint_state_publisher."""
