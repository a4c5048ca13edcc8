"""lifecycle: The tutorial of managed nodes, with a talker, a listener, and a client that changes the talker's states."""
