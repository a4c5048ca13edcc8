"""Rules over runs (`edulaunch.engine.recording.Recording`)."""
