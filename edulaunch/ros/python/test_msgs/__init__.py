"""Messages with all kinds of fields, for tests. The classes come from the interface files."""
