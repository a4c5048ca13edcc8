"""The default link: cyclonedds in this process."""
