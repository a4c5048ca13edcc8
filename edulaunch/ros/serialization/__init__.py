"""Messages in the forms in which ROS 2 gives them away; inside the simulation they are wire tuples, and none of this is needed.

`cdr.py` has the bytes of DDS and of bags. `type_description.py` has the descriptions and hashes of types by which ROS 2 programs
compare them. `message_text.py` has the YAML and CSV of `ros2 topic echo`.
"""
