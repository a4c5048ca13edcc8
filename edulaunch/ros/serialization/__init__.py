"""Converts messages to the forms that ROS 2 uses outside a program. Inside the simulation, messages are wire tuples, which do not
need this package.

`cdr.py` converts messages to the bytes of DDS and of bags. `type_description.py` creates the descriptions and hashes by which ROS
2 programs compare types. `message_text.py` writes the YAML and CSV of `ros2 topic echo`.
"""
