"""Compare a launch file in simulation and on real rclpy.

`observation` describes a run in either world, `simulated` and `for_real` create one, and `differing` lists the differences.
"""
