from setuptools import setup

setup(
    name='ferry_world',
    version='1.0.0',
    packages=['ferry_world'],
    data_files=[('share/ferry_world', ['package.xml']), ('share/ferry_world/launch', ['launch/ferry.launch.py'])],
    entry_points={'console_scripts': ['ferry = ferry_world.ferry:main']},
)
