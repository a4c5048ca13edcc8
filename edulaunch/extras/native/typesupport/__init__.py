"""Message, service and action classes of ours for the real rclpy, without a compiler.

rclpy looks for type support in capsules on the metaclass of a message class. They point to C structures whose layout rosidl
publishes; `abi` declares them for ctypes, `description` fills the type description, `messages`, `services` and `actions` the
rest, and `classes` finds which class is asked for. A message travels as its CDR bytes: where a compiled type has a C struct, ours
has a block of bytes.
"""
