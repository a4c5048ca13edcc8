"""The types in message definitions."""
