from setuptools import setup

setup(
    name='numbers',
    version='0.1.0',
    packages=['numbers'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/numbers']),
        ('share/numbers', ['package.xml']),
    ],
    entry_points={'console_scripts': ['arm = numbers.arm:main']},
)
