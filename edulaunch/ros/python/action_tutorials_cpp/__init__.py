"""action_tutorials_cpp: The action tutorial as its C++ programs behave: a server and a client of Fibonacci."""
