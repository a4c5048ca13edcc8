from glob import glob
import os

from setuptools import find_packages, setup

package_name = 'mistakes'

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
            'wrong_field = mistakes.wrong_field:main',
            'wrong_slot = mistakes.wrong_slot:main',
            'int_for_float = mistakes.int_for_float:main',
            'no_return = mistakes.no_return:main',
            'bad_name = mistakes.bad_name:main',
            'bad_topic = mistakes.bad_topic:main',
            'no_qos = mistakes.no_qos:main',
            'no_super = mistakes.no_super:main',
            'no_init = mistakes.no_init:main',
            'wrong_class = mistakes.wrong_class:main',
            'class_for_object = mistakes.class_for_object:main',
            'result_too_early = mistakes.result_too_early:main',
            'called_callback = mistakes.called_callback:main',
            'two_arguments = mistakes.two_arguments:main',
            'no_module = mistakes.no_module:main',
            'message_class = mistakes.message_class:main',
            'not_a_service = mistakes.not_a_service:main',
            'healthy = mistakes.healthy:main',
        ],
    },
)
