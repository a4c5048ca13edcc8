import ctypes

ctypes.CDLL("librobot_arm.so.3")
