from glob import glob

from setuptools import setup

package_name = 'convoy'

setup(
    name=package_name,
    version='0.1.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        ('share/' + package_name + '/launch', glob('launch/*')),
    ],
    install_requires=['setuptools'],
    maintainer='student',
    maintainer_email='student@example.org',
    description='A row of turtles that follow each other.',
    license='Apache-2.0',
    entry_points={'console_scripts': [
        'follower = convoy.follower:main',
    ]},
)
