from glob import glob

from setuptools import setup

package_name = 'where_now'

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
    description='A node that logs where turtle1 is, and where it was.',
    license='Apache-2.0',
    entry_points={'console_scripts': [
        'where = where_now.where:main',
    ]},
)
