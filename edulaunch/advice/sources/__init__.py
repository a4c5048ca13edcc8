"""Rules for the sources of packages (`PackageInWorkspace`)."""
