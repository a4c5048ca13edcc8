import cv2
import math

print(math.pi)
