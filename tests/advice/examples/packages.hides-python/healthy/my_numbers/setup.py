from setuptools import setup

setup(
    name='my_numbers',
    version='0.1.0',
    packages=['my_numbers'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/my_numbers']),
        ('share/my_numbers', ['package.xml']),
    ],
    entry_points={'console_scripts': ['arm = my_numbers.arm:main']},
)
