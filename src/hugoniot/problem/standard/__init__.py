"""Standard problems of the field, complete with how to judge a run and the numbers to beat.

`STANDARD[name].build(zones)` gives a frozen Problem. The exact answer is found by name in `theory.exact.SOLUTIONS`, which stands
above this room and is therefore not imported here.
"""

from hugoniot.problem.standard import gases, solids
from hugoniot.problem.standard.parts import Bar, Measure, StandardProblem

STANDARD: dict[str, StandardProblem] = {problem.name: problem for problem in (*gases.PROBLEMS, *solids.PROBLEMS)}

__all__ = ["STANDARD", "Bar", "Measure", "StandardProblem"]
