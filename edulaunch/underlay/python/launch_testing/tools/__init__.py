"""Tools for launch tests."""

from launch._lazy import lazy_exports

_EXPORTS = {
    'ProcessProxy': 'process',
    'basic_output_filter': 'output',
    'build_text_match': 'text',
    'expect_output': 'text',
    'expected_output_from_file': 'output',
    'launch_process': 'process',
    'process': '',
    'output': '',
    'text': '',
}
__all__ = [name for name, module in _EXPORTS.items() if module]
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
