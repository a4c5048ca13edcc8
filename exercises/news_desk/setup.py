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
        # TODO 1: the folder config belongs to the package, too
    ],
    install_requires=['setuptools'],
    maintainer='student',
    maintainer_email='student@example.org',
    description='Somebody who says the news, and somebody who hears it.',
    license='Apache-2.0',
    entry_points={'console_scripts': [
        'hello = news_desk.hello:main',
        # TODO 2: listen dies at once: which function of listen.py is its program?
        'listen = news_desk.listen:run',
    ]},
)
