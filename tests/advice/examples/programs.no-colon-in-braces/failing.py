SETTINGS = {'red': 200, 'green', 30}
print(SETTINGS)
