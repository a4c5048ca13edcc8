"""The bridge between a simulated machine and a real ROS 2 network. While the network is off, no part of the bridge is
imported.
"""
