"""Names of ROS 2's test tools that edulaunch does not have, with their alternatives. Fewer than five public repositories use
each of these names.
"""

_RUNNING = 'run the test file with `pytest` or `launch_test`'
_OUTPUT = 'compare with proc_output.assertWaitFor, or with assertInStdout of launch_testing.asserts'
_PROCESS = 'put the process into generate_test_description, or start it in the test with subprocess'
_EXIT_CODE = 'launch a program with ExecuteProcess, and look at its exit code with launch_testing.asserts.assertExitCodes'

ABSENT = {
    'all': {
        **dict.fromkeys(('LaunchTestRunner', 'LoadTestsFromPythonModule', 'print_arguments'), _RUNNING),
        'ReadyAggregator': 'put ReadyToTest behind what comes last, in an event handler',
    },
    'actions': dict.fromkeys(('GTest', 'PyTest', 'Test'), _EXIT_CODE),
    'legacy': dict.fromkeys(
        ('LaunchTestService', 'output'), f'write generate_test_description and a unittest class, and {_RUNNING}'
    ),
    'tools': {
        **dict.fromkeys(('basic_output_filter', 'expect_output', 'expected_output_from_file', 'output'), _OUTPUT),
        **dict.fromkeys(('launch_process', 'ProcessProxy', 'process'), _PROCESS),
    },
    'ros': {
        'DataRepublisher': 'a subscription whose callback publishes does the same',
        'LaunchTestRunner': _RUNNING,
        'tools': 'they filter the output of a middleware, which the simulation does not have; use proc_output.assertWaitFor',
    },
}
"""Part of the tools -> name -> the advice in the ImportError for that name."""
