"""The explorer: materials, impacts, runs, decks and sweeps in a browser, served to this machine alone or exported as a folder."""
