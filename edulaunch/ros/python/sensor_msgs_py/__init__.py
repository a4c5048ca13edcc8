"""Reading and making sensor messages in Python; see `point_cloud2`."""
