"""Names as people type them: one spelling for comparison, nearest names, and a search over everything the library holds."""

import difflib
import re
import unicodedata
from collections.abc import Iterable, Mapping

# one spelling of words that people write in several
_SAME = {"aluminium": "aluminum", "sulphur": "sulfur", "grey": "gray", "polythene": "polyethylene", "plexiglass": "plexiglas"}


_SYMBOLS = {
    "ag": "silver", "al": "aluminum", "au": "gold", "ba": "barium", "be": "beryllium", "bi": "bismuth", "ca": "calcium", "cd":
    "cadmium", "co": "cobalt", "cr": "chromium", "cs": "cesium", "cu": "copper", "fe": "iron", "ge": "germanium", "hg": "mercury",
    "in": "indium", "k": "potassium", "li": "lithium", "mg": "magnesium", "mo": "molybdenum", "na": "sodium", "nb": "niobium", "ni":
    "nickel", "pb": "lead", "pd": "palladium", "pt": "platinum", "rb": "rubidium", "rh": "rhodium", "sn": "tin", "sr": "strontium",
    "ta": "tantalum", "th": "thorium", "ti": "titanium", "tl": "thallium", "u": "uranium", "v": "vanadium", "w": "tungsten", "zn":
    "zinc", "zr": "zirconium",
}


def substance(name: str) -> str:
    """What a row of the tables is of, without the remarks on its state: "Bi" and "Bismuth, 0.3 to 1.1 km/s" are of bismuth."""
    text = spelling(re.split(r"[,(]", name)[0])
    return _SYMBOLS.get(text, text)


def spelling(name: str) -> str:
    """A name reduced to what tells it from others: lower case letters and digits, one spelling of aluminium."""
    text = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode().lower()
    for ours, theirs in _SAME.items():
        text = text.replace(ours, theirs)
    return re.sub(r"[^a-z0-9]", "", text)


def parts(name: str) -> tuple[str, ...]:
    """The runs of letters and of digits of a name, in one spelling and any order: "304 stainless" has those of "stainless 304"."""
    text = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode().lower()
    for ours, theirs in _SAME.items():
        text = text.replace(ours, theirs)
    return tuple(sorted("aluminum" if run == "al" else run for run in re.findall(r"[a-z]+|[0-9]+", text)))


def words(text: str) -> set[str]:
    """The words and numbers of a text, each in one spelling."""
    return {w for w in (spelling(p) for p in re.findall(r"[^\s,;()/]+", text)) if w}


def nearest(name: str, known: Mapping[str, str], count: int = 5) -> list[str]:
    """Names of the library most like `name`; `known` maps spelling -> name."""
    asked = spelling(name)
    near = difflib.get_close_matches(asked, list(known), n=3 * count, cutoff=0.55)
    likeness = [difflib.SequenceMatcher(None, s, asked).ratio() for s in near]
    near = [s for s, alike in zip(near, likeness) if alike > likeness[0] - 0.2]     # beside a slip of one letter the rest is noise
    inside = [s for s in known if len(asked) > 2 and asked in s]
    return list(dict.fromkeys(known[s] for s in (*near[:1], *inside, *near)))[:count]


def matches(query: str, texts: Iterable[str]) -> bool:
    """Whether every word of the query is found in one of the texts."""
    joined = " ".join(" ".join(sorted(words(t))) + " " + spelling(t) for t in texts)
    return all(w in joined for w in words(query))
