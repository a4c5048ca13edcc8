import ctypes

print(ctypes.c_int(3).value)
