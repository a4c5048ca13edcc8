from robot.arm import main

WIDTH = 3
