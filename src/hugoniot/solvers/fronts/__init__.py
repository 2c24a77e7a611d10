"""Tracked fronts in one dimension: every shock, contact, fan edge and surface is a line, and nothing is smeared across it."""
