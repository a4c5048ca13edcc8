"""action_tutorials_py: The action tutorial: a server and a client of Fibonacci."""
