"""Made by `edulaunch course template jupyterhub`. A container for each student, from the image that the template docker makes:

docker build -t @COURSE@-hub --build-arg ALSO=jupyterhub .
python -m pip install jupyterhub dockerspawner
jupyterhub -f jupyterhub/jupyterhub_config.py

Who may log in (an Authenticator) and the address are your site's business; without one JupyterHub asks the system for users.
"""

c = get_config()  # noqa: F821
c.JupyterHub.spawner_class = 'dockerspawner.DockerSpawner'
c.JupyterHub.hub_ip = '0.0.0.0'  # containers must reach it
c.DockerSpawner.image = '@COURSE@-hub'
c.DockerSpawner.cmd = ['jupyterhub-singleuser']
c.DockerSpawner.remove = True
c.DockerSpawner.notebook_dir = '/home/student/course'
c.DockerSpawner.volumes = {'@COURSE@-{username}': '/home/student/course'}  # new ones begin as a copy of the image's folder
c.DockerSpawner.default_url = '/lab/tree/lessons'
c.DockerSpawner.mem_limit = '1G'
c.DockerSpawner.cpu_limit = 1.0
