def squares(n):
    return [float(i * i) for i in range(n)]
