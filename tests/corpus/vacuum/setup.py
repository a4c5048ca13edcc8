from pathlib import Path

from setuptools import setup

name = Path(__file__).parent.name


def tree(*folders):
    found = []
    for folder in folders:
        for file in sorted(Path(folder).rglob('*')):
            if file.is_file():
                found.append((str(Path('share') / name / file.parent), [str(file)]))
    return found


setup(
    name=name,
    version='0.0.0',
    packages=[name],
    data_files=[('share/ament_index/resource_index/packages', ['resource/' + name]),
                ('share/' + name, ['package.xml']),
                *tree('launch', 'config')],
    install_requires=['setuptools', 'numpy'],
    zip_safe=True,
    entry_points={'console_scripts': [
        'base = vacuum.base:main',
        'lidar = vacuum.lidar:main',
        'brain = vacuum.brain:main',
        'mapper = vacuum.mapper:main',
    ]},
)
