"""lifecycle: the tutorial of managed nodes (a talker, a listener, and a client that leads the talker through its states)."""
