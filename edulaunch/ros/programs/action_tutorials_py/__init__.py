"""action_tutorials_py: The action tutorial with a server and a client for Fibonacci numbers."""
