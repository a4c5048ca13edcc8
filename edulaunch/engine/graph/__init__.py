"""The in-memory ROS graph: names, nodes, topics with QoS, services, parameter values.

Read `graph.py` first; `members.py` has who comes and goes, `topics.py` and `services.py` how messages are delivered.
Delivery takes no simulated time and crosses process boundaries only as wire tuples (plain immutable data), traced before
anybody else sees them.
"""

from __future__ import annotations
