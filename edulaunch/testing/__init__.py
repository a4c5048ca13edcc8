"""Tests of a package, plain ones and those of launch_pytest, on the simulated machine of a run of pytest."""
