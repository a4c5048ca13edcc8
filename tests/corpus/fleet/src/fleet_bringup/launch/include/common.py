from launch.substitutions import LaunchConfiguration

def lc(n):
    return LaunchConfiguration(n)
