"""The bridge between a simulated machine and a real ROS 2 network; while the network is off, no part of it is imported."""
