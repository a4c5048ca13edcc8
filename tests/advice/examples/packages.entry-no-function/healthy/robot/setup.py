from setuptools import setup

setup(
    name='robot',
    version='0.1.0',
    packages=['robot'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/robot']),
        ('share/robot', ['package.xml']),
    ],
    entry_points={'console_scripts': ['arm = robot.arm:main']},
)
