"""The commands of `hugoniot eos`: `app` declares them, and each file beside it asks theory one kind of question and prints the answer."""
