import glob
from setuptools import setup
setup(
    name='fleet_drivers', version='2.4.1', packages=['fleet_drivers'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/fleet_drivers']),
        ('share/fleet_drivers', ['package.xml']),
        ('share/fleet_drivers/launch', glob.glob('launch/*.py') + glob.glob('launch/*.xml')),
        ('share/fleet_drivers/config', glob.glob('config/*')),
    ],
    entry_points={'console_scripts': ['motor = fleet_drivers.motor:main', 'selftest = fleet_drivers.selftest:main', 'bms=fleet_drivers.bms:main']},
)
