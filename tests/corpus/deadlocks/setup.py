from glob import glob
import os

from setuptools import find_packages, setup

package_name = 'deadlocks'

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        (os.path.join('share', package_name, 'launch'), glob('launch/*.launch.py')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='student',
    maintainer_email='student@example.org',
    description='Course work',
    license='Apache-2.0',
    tests_require=['pytest'],
    entry_points={
        'console_scripts': [
            'nested_spin = deadlocks.nested_spin:main',
            'sync_call = deadlocks.sync_call:main',
            'busy_wait = deadlocks.busy_wait:main',
            'rate_in_timer = deadlocks.rate_in_timer:main',
            'await_in_group = deadlocks.await_in_group:main',
            'nested_once = deadlocks.nested_once:main',
            'healthy = deadlocks.healthy:main',
        ],
    },
)
