"""Tools for launch tests."""
from launch._lazy import lazy_exports

_EXPORTS = {
    'ProcessProxy': 'process',
    'basic_output_filter': 'output',
    'build_text_match': 'text',
    'expect_output': 'text',
    'launch_process': 'process',
    'process': '',
    'output': '',
    'text': '',
}
__all__ = ['ProcessProxy', 'basic_output_filter', 'build_text_match', 'expect_output', 'launch_process']
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
