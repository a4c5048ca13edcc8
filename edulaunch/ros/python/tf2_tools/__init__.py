"""Tools that look at tf2 from outside."""
