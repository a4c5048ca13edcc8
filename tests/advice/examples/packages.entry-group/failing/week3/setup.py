import os
from glob import glob
from setuptools import setup

package_name = 'week3'

setup(
    name=package_name,
    version='0.0.1',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        (os.path.join('share', package_name, 'launch'), glob('launch/*')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='me',
    maintainer_email='me@uni.example',
    description='Homework',
    license='MIT',
    entry_points={
        'console_script': [
            'hello = week3.hello:main',
            'hear = week3.hear:main',
        ],
    },
)
