"""The equation of state for an exact solution of any material: by a name of the library, or as a law or material object."""

from hugoniot.theory.states import law_of


def law_named(material):
    """Parameters of the equation of state of a material, a law, or a name of the library; UnknownMaterial for another name."""
    if isinstance(material, str):
        from hugoniot.materials import library  # its tables are not needed by the ideal-gas solutions

        return library.find(material).eos
    return law_of(material)
