"""What follows from the data of a material with the help of theory: derived numbers, curves to compare, checks, descriptions."""
