"""Message, service and action classes of edulaunch for the real rclpy, without a compiler.

rclpy looks for type support in capsules on the metaclass of a message class. The capsules point to C structures whose layout
rosidl publishes. `abi` declares these structures for ctypes, and `description` fills in the type description. `messages`,
`services` and `actions` fill in the other fields, and `classes` selects the class for a type. A message travels as its CDR
bytes. In place of the C struct of a compiled type, edulaunch's type has a block of bytes.
"""
