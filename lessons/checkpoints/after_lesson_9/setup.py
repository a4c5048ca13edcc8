from glob import glob

from setuptools import setup

package_name = 'learning_tf2_py'
programs = [
    'static_turtle_tf2_broadcaster',
    'turtle_tf2_broadcaster',
    'turtle_spawner',
    'turtle_tf2_listener',
]

setup(
    name=package_name, version='0.0.1', packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', [f'resource/{package_name}']),
        (f'share/{package_name}', ['package.xml']),
        (f'share/{package_name}/launch', glob('launch/*.launch.py')),
    ],
    entry_points={'console_scripts': [f'{name} = {package_name}.{name}:main' for name in programs]},
)
