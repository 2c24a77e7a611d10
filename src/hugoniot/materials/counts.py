"""How many materials the library has, by kind and by where their numbers come from: what `hugoniot material list --counts` prints."""

from collections import Counter
from collections.abc import Iterable

from hugoniot.materials import library, schema

# a word of a category -> the kind it is counted under; the first that fits
KINDS = (("explosive", "explosive"), ("metal", "metal"), ("polymer", "polymer"), ("gas", "gas"), ("ice", "ice"), ("liquid", "liquid"),
         ("foam", "foam, wood, porous"), ("wood", "foam, wood, porous"), ("ceramic", "ceramic, glass"), ("glass", "ceramic, glass"),
         ("crystal", "salt, window crystal"), ("rock", "rock, soil"), ("soil", "rock, soil"), ("mineral", "mineral"))


def kind(category: str) -> str:
    """The kind a category is counted under."""
    return next((name for word, name in KINDS if word in category), "composite and other")


def by_kind() -> dict[str, dict[str, int]]:
    """kind -> {curated, rows_only, shock, compression}: materials with a curated file, and those only the tables have.

    Of the latter `compression` counts those with static compression only, `shock` all others (shock data, explosives, Tillotson, gases).
    """
    found: dict[str, Counter] = {}
    for listing in library.listings():
        count = found.setdefault(kind(listing.category), Counter(curated=0, rows_only=0, shock=0, compression=0))
        if listing.curated:
            count["curated"] += 1
            continue
        count["rows_only"] += 1
        count["compression" if {schema.row(i).table for i in listing.rows} == {"compression"} else "shock"] += 1
    return {name: dict(found[name]) for name in sorted(found, key=lambda n: -found[n]["curated"] - found[n]["rows_only"])}


def by_source(rows: Iterable[schema.Row] | None = None) -> dict[str, int]:
    """First words of the source, up to the first comma or semicolon -> number of rows."""
    count = Counter(row.source.replace(";", ",").split(",")[0].strip() for row in (schema.all_rows() if rows is None else rows))
    return dict(count.most_common())


def known() -> dict[str, int]:
    """How many rows have what few of them have: words -> number."""
    shocks, presses = (list(schema.table(name).values()) for name in ("us_up", "compression"))
    return {
        "Us-up rows": len(shocks), "with a range": _with(shocks, "up_max"), "with measured states": _with(shocks, "states"),
        "with a deviation of Us": _with(shocks, "us_deviation"), "with standard deviations of c0 and s": _with(shocks, "c0_deviation"),
        "static compressions": len(presses), "with a highest pressure": _with(presses, "p_max"),
        "with a standard deviation": _with(presses, "bulk_modulus_deviation"),
        "spall strengths": _with(schema.table("strength").values(), "spall_strength"),
    }


def ranges_by_kind() -> dict[str, dict[str, int]]:
    """kind -> {rows, range, deviation, states} of the Us-up rows: how many there are, and how many have what."""
    found: dict[str, Counter] = {}
    for row in schema.table("us_up").values():
        count = found.setdefault(kind(row["category"]), Counter(rows=0, range=0, deviation=0, states=0))
        count.update(rows=1, range="up_max" in row, deviation="us_deviation" in row, states="states" in row)
    return {name: dict(found[name]) for name in sorted(found, key=lambda n: -found[n]["rows"])}


def _with(rows: Iterable[schema.Row], quantity: str) -> int:
    return sum(quantity in row for row in rows)
