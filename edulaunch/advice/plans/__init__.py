"""Rules over dry runs of launch files (`edulaunch.plan.Rehearsal`)."""
