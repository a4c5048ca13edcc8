import queue

print(queue.Queue())
