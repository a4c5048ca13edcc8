"""Rules for dry runs of launch files (`edulaunch.advice.plan.Rehearsal`)."""
