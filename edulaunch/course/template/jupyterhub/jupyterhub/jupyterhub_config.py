"""Created by `edulaunch course template jupyterhub`. Each student gets a container from the image of the template docker:

docker build -t @COURSE@-hub --build-arg ALSO=jupyterhub .
python -m pip install jupyterhub dockerspawner
jupyterhub -f jupyterhub/jupyterhub_config.py

Your site chooses who may log in (an Authenticator) and the address. Without an Authenticator, JupyterHub uses system accounts.
"""

c = get_config()  # noqa: F821
c.JupyterHub.spawner_class = 'dockerspawner.DockerSpawner'
c.JupyterHub.hub_ip = '0.0.0.0'  # containers must reach it
c.DockerSpawner.image = '@COURSE@-hub'
c.DockerSpawner.cmd = ['jupyterhub-singleuser']
c.DockerSpawner.remove = True
c.DockerSpawner.notebook_dir = '/home/student/course'
c.DockerSpawner.volumes = {'@COURSE@-{username}': '/home/student/course'}  # a new volume begins as a copy of the image's folder
c.DockerSpawner.default_url = '/lab/tree/lessons'
c.DockerSpawner.mem_limit = '1G'
c.DockerSpawner.cpu_limit = 1.0
