"""The page of the explorer, of exports and of reports: its files, and what it draws of a run."""
