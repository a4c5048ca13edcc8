"""Our message, service and action classes for the real rclpy, without a compiler.

rclpy looks for type support in capsules on the metaclass of a message class. They point to C structures whose layout rosidl
publishes. `abi` declares them for ctypes, `description` fills the type description, `messages`, `services` and `actions` the
rest, and `classes` chooses the class for a type. A message travels as its CDR bytes: our type has a block of bytes in place of
the C struct of a compiled type.
"""
