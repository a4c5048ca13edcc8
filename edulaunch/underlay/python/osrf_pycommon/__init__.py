"""The parts of osrf_pycommon that launch and its extensions use."""
