from glob import glob

from setuptools import setup

package_name = 'news_desk'

setup(
    name=package_name,
    version='0.1.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        ('share/' + package_name + '/launch', glob('launch/*')),
        ('share/' + package_name + '/config', glob('config/*')),
    ],
    install_requires=['setuptools'],
    maintainer='student',
    maintainer_email='student@example.org',
    description='A publisher of news and a subscriber.',
    license='Apache-2.0',
    entry_points={'console_scripts': [
        'hello = news_desk.hello:main',
        'listen = news_desk.listen:main',
    ]},
)
