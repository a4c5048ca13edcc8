GREETINGS = ['hello', 'hola']


def describe(node):
    return node.get_fully_qualified_name()
