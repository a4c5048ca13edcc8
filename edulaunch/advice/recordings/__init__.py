"""Rules over runs (`edulaunch.recording.Recording`)."""
