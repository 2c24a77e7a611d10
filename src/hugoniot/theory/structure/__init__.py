r"""The structure of a steady shock, in which viscosity and heat conduction replace the jump of ideal theory.

`steady(...)` gives the profile of a shock in any equation of state with any transport law; `analytic` the closed-form solutions;
`jordan` the cases of Jordan. Derivation and results: docs/theory/shock_structure.md.
"""

from hugoniot.theory.structure.ends import Ends, find_ends
from hugoniot.theory.structure.profile import Profile, steady

__all__ = ["Ends", "Profile", "find_ends", "steady"]
