print('hello', 'again')
