x = 1
for _ in range(20):
    print(x)
