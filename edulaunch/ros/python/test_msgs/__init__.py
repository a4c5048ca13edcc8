"""Messages of all kinds of fields, for tests; the classes come from the interface files."""
