import rclpy
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient


def main():
    rclpy.init()
    node = rclpy.create_node('tuner')
    client = AsyncParameterClient(node, 'plant')
    log = node.get_logger()

    def wait(future):
        rclpy.spin_until_future_complete(node, future)
        return future.result()

    if not client.wait_for_services(timeout_sec=2.0):
        log.error('no plant')
        return 1
    for name, value in (('pid.kp', 5.0), ('pid.kp', 5.2), ('pid.kp', 30.0), ('target', 60.0), ('target', 'hot'), ('pid.kq', 1.0)):
        result = wait(client.set_parameters([Parameter(name, value=value)])).results[0]
        log.info(f'{name} = {value}: {result.successful} {result.reason}')
    both = [Parameter('pid.ki', value=0.5), Parameter('target', value=99.0)]
    log.info(str(wait(client.set_parameters_atomically(both)).result))
    log.info(str([r.successful for r in wait(client.set_parameters(both)).results]))
    log.info(str(wait(client.list_parameters(['pid'], 10)).result))
    log.info(str([parameter_value_to_python(v) for v in wait(client.get_parameters(['pid.kp', 'pid.ki', 'target'])).values]))
    log.info(str(wait(client.describe_parameters(['pid.kp'])).descriptors[0].floating_point_range))
    node.destroy_node()
    rclpy.shutdown()
