"""Dual numbers with two independent directions: exact first derivatives of any law written with core.ops."""

import math


class Dual:
    """value + x d/dx + y d/dy. Comparisons look at the value alone; both slopes are plain floats."""

    __slots__ = ("v", "x", "y")

    def __init__(self, v, x=0.0, y=0.0):
        self.v, self.x, self.y = v, x, y

    def __add__(self, o):
        return Dual(self.v + o.v, self.x + o.x, self.y + o.y) if isinstance(o, Dual) else Dual(self.v + o, self.x, self.y)

    __radd__ = __add__

    def __neg__(self):
        return Dual(-self.v, -self.x, -self.y)

    def __sub__(self, o):
        return Dual(self.v - o.v, self.x - o.x, self.y - o.y) if isinstance(o, Dual) else Dual(self.v - o, self.x, self.y)

    def __rsub__(self, o):
        return Dual(o - self.v, -self.x, -self.y)

    def __mul__(self, o):
        if isinstance(o, Dual):
            return Dual(self.v * o.v, self.x * o.v + self.v * o.x, self.y * o.v + self.v * o.y)
        return Dual(self.v * o, self.x * o, self.y * o)

    __rmul__ = __mul__

    def __truediv__(self, o):
        if isinstance(o, Dual):
            r = 1.0 / o.v
            q = self.v * r
            return Dual(q, (self.x - q * o.x) * r, (self.y - q * o.y) * r)
        r = 1.0 / o
        return Dual(self.v / o, self.x * r, self.y * r)

    def __rtruediv__(self, o):
        q = o / self.v
        slope = -q / self.v
        return Dual(q, slope * self.x, slope * self.y)

    def __lt__(self, o):
        return self.v < (o.v if isinstance(o, Dual) else o)

    def __gt__(self, o):
        return self.v > (o.v if isinstance(o, Dual) else o)

    def __le__(self, o):
        return self.v <= (o.v if isinstance(o, Dual) else o)

    def __ge__(self, o):
        return self.v >= (o.v if isinstance(o, Dual) else o)

    def __eq__(self, o):
        return self.v == (o.v if isinstance(o, Dual) else o)

    __hash__ = None

    def __float__(self):
        raise TypeError("a dual number lost its slopes: the law left the operations of core.ops")

    # numpy's exp, log and sqrt call these on objects
    def exp(self):
        f = math.exp(self.v)
        return Dual(f, f * self.x, f * self.y)

    def log(self):
        r = 1.0 / self.v
        return Dual(math.log(self.v), r * self.x, r * self.y)

    def sqrt(self):
        f = math.sqrt(self.v)
        r = 0.5 / f
        return Dual(f, r * self.x, r * self.y)


def value(a):
    """The value of a dual or a float."""
    return a.v if isinstance(a, Dual) else a


def slopes(a):
    """Both slopes of a dual; zeros for a float."""
    return (a.x, a.y) if isinstance(a, Dual) else (0.0, 0.0)
