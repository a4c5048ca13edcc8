"""The in-memory ROS graph: names, nodes, topics with QoS, services, parameter values.

Read `graph.py` first; `topics.py` and `services.py` are how things are delivered. Delivery takes no simulated time and
crosses process boundaries only as wire tuples (plain immutable data), traced before anybody else sees them.
"""

from __future__ import annotations
