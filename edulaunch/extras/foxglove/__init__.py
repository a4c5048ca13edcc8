"""A server that shows the shared machine or a recording to Foxglove, Lichtblick and other clients of their WebSocket protocol.

`protocol.py` parses messages of clients, and `server_messages.py` creates messages of the server. `conversation.py` handles
one client. The data come from a feed: `live.py` for a machine that runs, and `recorded.py` for a recording that plays.
`server.py` has the web sockets. `service.py` runs in the machine's process.
"""
