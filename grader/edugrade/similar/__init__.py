"""``edugrade similar``: who handed in what others handed in too, side by side, for a person to judge."""
