from glob import glob

from setuptools import setup

setup(
    name='robo',
    version='0.0.1',
    packages=['robo'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/robo']),
        ('share/robo', ['package.xml']),
        ('share/robo/launch', glob('launch/*.launch.py')),
    ],
    entry_points={'console_scripts': [
        'walker = robo.walker:main',
        'runner = robo.runner:main',
    ]},
)
