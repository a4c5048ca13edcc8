"""action_tutorials_cpp: The action tutorial with the behaviour of its C++ programs, a server and a client of Fibonacci."""
