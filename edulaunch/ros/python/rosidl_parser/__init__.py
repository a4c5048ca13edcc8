"""The types that message definitions are made of."""
