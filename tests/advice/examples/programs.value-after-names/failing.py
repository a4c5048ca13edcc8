print('hello', end='', 'again')
