import subprocess

subprocess.run(['ros2', 'node', 'list'])
