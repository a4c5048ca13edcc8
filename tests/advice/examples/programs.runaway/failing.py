x = 1
for _ in range(20000):
    print(x)
