"""Problems of the two-dimensional hydrocode: what is asked (`model`), its deck and the mesh and lighting made from it."""
