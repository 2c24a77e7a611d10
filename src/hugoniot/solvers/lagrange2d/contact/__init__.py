"""Contact between bodies: surfaces that meet, slide and separate, by Gauss's principle of least constraint."""
