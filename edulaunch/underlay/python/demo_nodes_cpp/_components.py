"""Those nodes of this package that a container makes in a way of their own; `components.txt` names them."""

from __future__ import annotations

from functools import partial

from rclpy.qos import qos_profile_sensor_data

from demo_nodes_cpp._hearing import Listener
from demo_nodes_cpp._two_timers import TwoTimers

listener = partial(Listener, 'listener', 10)
listener_best_effort = partial(Listener, 'listener', qos_profile_sensor_data)
one_off_timer = partial(TwoTimers, 'one_off_timer', reuse=False)
reuse_timer = partial(TwoTimers, 'reuse_timer', reuse=True)
