import os
from glob import glob

from setuptools import find_packages, setup

package_name = 'robot'

setup(
    name=package_name,
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/' + package_name, ['package.xml']),
    ],
    entry_points={'console_scripts': ['drive = robo.drive:main']},
)
