def brake():
    if True:
        return 2
