"""Tools for launch tests."""

from launch._lazy import lazy_exports

_EXPORTS = {'build_text_match': 'text', 'text': ''}
_OUTPUT = 'compare with proc_output.assertWaitFor, or with assertInStdout of launch_testing.asserts'
_PROCESS = 'put the process into generate_test_description, or start it in the test with subprocess'
_ABSENT = {
    **dict.fromkeys(('basic_output_filter', 'expect_output', 'expected_output_from_file', 'output'), _OUTPUT),
    **dict.fromkeys(('launch_process', 'ProcessProxy', 'process'), _PROCESS),
}
__all__ = ['build_text_match']
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, absent=_ABSENT)
