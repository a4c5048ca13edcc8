"""A server for Foxglove, Lichtblick and other clients of their WebSocket protocol: the shared machine, or a recording.

`protocol.py` reads what clients say, and `said.py` makes what a server says. `conversation.py` is the server's end of one client.
It gets its data from a feed: `live.py` is a machine that runs, and `recorded.py` a recording that plays. `server.py` has the web
sockets. `service.py` runs in the machine's process.
"""
