def move():
    pass
