"""What to say where no single shock leads to a state: the wave splits in two."""

from hugoniot.cli.eos.output import cell
from hugoniot.errors import HugoniotError
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.split import split_wave
from hugoniot.theory.states import States


def split_notes(material, single: States, ahead: Initial | None = None, name: str = "") -> list[str]:
    """The note about a shock from `ahead` (default: rest) to the state `single`; `name` where several materials are spoken of."""
    found = split_wave(material, ahead or Initial.at_rest(material), single)
    if found is None:
        return []
    first, second = ([cell(key, getattr(state, key)) for key in ("pressure", "shock_velocity", "density")] for state in found)
    return [f"{name + ': ' if name else ''}no single shock leads to up = {cell('particle_velocity', single.particle_velocity)}: a "
            f"precursor to {first[0]} runs ahead at {first[1]}, and a second shock at {second[1]} follows, to {second[0]} and {second[2]}"]


def jump_notes(material, jump: float, ahead: Initial | None = None) -> list[str]:
    """The same of a shock that changes the particle velocity by `jump`, m/s; none where the law has no such shock."""
    ahead = ahead or Initial.at_rest(material)
    if not jump > 0.0 or ahead.heat:
        return []
    try:
        return split_notes(material, shock(material, ahead, particle_velocity=ahead.velocity + jump), ahead, material.name)
    except HugoniotError:
        return []
