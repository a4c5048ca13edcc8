"""Rules over the sources of packages (`Source`)."""
