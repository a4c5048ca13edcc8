"""Compare a run of a launch file in simulation with a run on the real rclpy.

`observation` describes either kind of run, `simulated` and `for_real` create an observation, and `differing` lists the
differences.
"""
