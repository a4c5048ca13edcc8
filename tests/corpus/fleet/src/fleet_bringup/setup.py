from pathlib import Path
from setuptools import setup, find_packages

name = Path(__file__).parent.name

def tree(*dirs):
    out = []
    for d in dirs:
        for f in sorted(Path(d).rglob('*')):
            if f.is_file():
                out.append((str(Path('share') / name / f.parent), [str(f)]))
    return out

setup(
    name=name, version='2.4.1', packages=find_packages(),
    data_files=[('share/ament_index/resource_index/packages', ['resource/' + name]), ('share/' + name, ['package.xml']), *tree('launch', 'config')],
    install_requires=['setuptools'], zip_safe=False,
)
