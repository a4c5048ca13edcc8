"""Messages with all kinds of fields, for tests. The classes are generated from the interface files."""
