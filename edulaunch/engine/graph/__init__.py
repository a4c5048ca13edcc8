"""The ROS graph in memory: names, nodes, topics with QoS, services, parameter values.

Read `graph.py` first. `members.py` adds and removes nodes and endpoints, and `topics.py` and `services.py` deliver messages.
Delivery takes no simulated time. Only wire tuples (plain immutable data) cross process boundaries, and the tracer receives
each wire tuple before its receiver.
"""

from __future__ import annotations
