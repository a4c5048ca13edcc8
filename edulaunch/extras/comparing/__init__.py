"""A launch file in simulation and for real, side by side.

`observation` is what can be seen of a run in either world; `simulated` and `for_real` make one; `differing` says what differs.
"""
