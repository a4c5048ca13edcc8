"""Rules over packages' sources (`Source`)."""
