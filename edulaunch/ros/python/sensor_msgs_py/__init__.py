"""Functions that read and create sensor messages; see `point_cloud2`."""
