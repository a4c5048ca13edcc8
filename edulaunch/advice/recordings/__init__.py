"""Rules for runs (`edulaunch.engine.recording.Recording`)."""
