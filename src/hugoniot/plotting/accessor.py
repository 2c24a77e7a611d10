"""`run.plot`: the pictures of one run by name. Every method gives matplotlib axes; `ax=` draws into yours."""

from hugoniot.plotting import plane, records
from hugoniot.plotting.setup import setup
from hugoniot.plotting.xt import xt
from hugoniot.plotting.yield_plane import pi_plane


class RunPlots:
    """Pictures of a `Run`, drawn with matplotlib. Every method returns the axes; with `ax=` it draws into the axes given."""

    def __init__(self, run):
        self._run = run

    def xt(self, field: str = "stress", **options):
        """Wave diagram: a field of the zones against position and time."""
        return xt(self._run, field, **options)

    def gauge(self, field: str = "", names=None, **options):
        """A field (default: the stress, or the pressure in two dimensions) at the gauges `names` (default: all) against time."""
        return records.gauge(self._run, field, names if names is None or isinstance(names, (list, tuple)) else [names], **options)

    def pi_plane(self, names=None, **options):
        """Stress deviators at the gauges `names` in the pi-plane, in which the yield surface is a circle."""
        return pi_plane(self._run, names if names is None or isinstance(names, (list, tuple)) else [names], **options)

    def free_surface(self, name: str | None = None, **options):
        """Free-surface velocity with its pull-back; with `delay` (s), as a VISAR with this delay records it."""
        return records.free_surface(self._run, name, **options)

    def profile(self, field: str | None = None, time=None, **options):
        """A field of the zones against position at one or more times (s); in two dimensions along a line from `start` to `end` (m)."""
        if "axes" in self._run.setup:
            return plane.line_profile(self._run, field or "pressure", time, **options)
        return records.profile(self._run, field or "stress", time, **options)

    def map(self, field: str = "pressure", time=None, **options):
        """A map of a field at one time (s), in two dimensions."""
        return plane.map_(self._run, field, time, **options)

    def peaks(self, field: str = "stress", **options):
        """Extreme value of a field in each zone, against the position of the zone at t = 0."""
        return records.peaks(self._run, field, **options)

    def budget(self, **options):
        """Parts of the energy against time."""
        return records.budget(self._run, **options)

    def errors(self, **options):
        """Errors of mass, momentum and energy against time."""
        return records.errors(self._run, **options)

    def setup(self, **options):
        """The bodies at t = 0, to scale."""
        if "axes" in self._run.setup:
            return plane.plane_setup(self._run, **options)
        return setup(self._run, **options)


PICTURES = ("xt", "gauge", "pi_plane", "free_surface", "profile", "peaks", "budget", "errors", "setup")
PLANE_PICTURES = ("map", "gauge", "pi_plane", "profile", "budget", "errors", "setup")     # of runs of two dimensions
