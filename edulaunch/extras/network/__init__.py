"""The bridge between a simulated machine and a real ROS 2 network; nothing of it is imported while the network is off."""
