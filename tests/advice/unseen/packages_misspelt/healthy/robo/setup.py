from setuptools import find_packages, setup

setup(
    name='robo',
    version='0.0.1',
    packages=['robo'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/robo']),
        ('share/robo', ['package.xml']),
    ],
    install_requires=['setuptools'],
    entry_points={'console_scripts': ['walker = robo.walker:main']},
)
