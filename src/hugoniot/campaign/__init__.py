"""Many runs: verification of the built-in standard problems."""
