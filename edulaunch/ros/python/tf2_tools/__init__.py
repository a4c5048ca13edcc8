"""Tools that show the frames of tf2."""
