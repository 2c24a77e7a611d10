r"""Single-material cards of LS-DYNA keyword files as tables of a material: EOS_GRUNEISEN, EOS_JWL, MAT_JOHNSON_COOK.

Its Grüneisen form is this package's, with E per initial volume and $a$ the first-order volume correction:

$$p = \frac{\rho_0C^2\mu\left[1 + (1-\frac{\gamma_0}2)\mu - \frac a2\mu^2\right]}{\left[1 - (S_1-1)\mu - S_2\frac{\mu^2}{\mu+1} -
  S_3\frac{\mu^3}{(\mu+1)^2}\right]^2} + (\gamma_0 + a\mu)E, \qquad \Gamma = \frac{\gamma_0 + a\mu}{1+\mu},$$

the Hugoniot $U_s = C + S_1u_p + S_2(u_p/U_s)u_p + S_3(u_p/U_s)^2u_p$, in compression. In expansion LS-DYNA takes
$\rho_0C^2\mu + (\gamma_0 + a\mu)E$, this package an isentrope of the same slope (`tension_note`). A file is fields of ten columns,
twenty in the long format, or separated by commas; numbers are in a consistent system that it does not name. Source: LS-DYNA Keyword
User's Manual, volume II (*EOS_GRUNEISEN, *EOS_JWL, *MAT_015, *MAT_008).
"""

from typing import Any, NamedTuple

from hugoniot.errors import DeckError
from hugoniot.laws.eos.contract import pressure, reference_state
from hugoniot.materials.collect import printable
from hugoniot.units import UnitError, parse

# names of the fields, card by card; the first is an identifier
CARDS = {
    "EOS_GRUNEISEN": (("EOSID", "C", "S1", "S2", "S3", "GAMAO", "A", "E0"), ("V0", "", "LCID")),
    "EOS_JWL": (("EOSID", "A", "B", "R1", "R2", "OMEG", "E0", "VO"),),
    "MAT_JOHNSON_COOK": (("MID", "RO", "G", "E", "PR", "DTF", "VP", "RATEOP"), ("A", "B", "N", "C", "M", "TM", "TR", "EPSO"),
                         ("CP", "PC", "SPALL", "IT", "D1", "D2", "D3", "D4"), ("D5", "C2", "EROD", "EFMIN", "NUMINT")),
    "MAT_HIGH_EXPLOSIVE_BURN": (("MID", "RO", "D", "PCJ", "BETA", "K", "G", "SIGY"),),
}
# first field of the last line that a card must have
LAST = {"EOS_GRUNEISEN": "C", "EOS_JWL": "A", "MAT_JOHNSON_COOK": "CP", "MAT_HIGH_EXPLOSIVE_BURN": "RO"}
NUMBERS = {"MAT_015": "MAT_JOHNSON_COOK", "MAT_008": "MAT_HIGH_EXPLOSIVE_BURN", "EOS_002": "EOS_JWL", "EOS_004": "EOS_GRUNEISEN"}
WIDTH, LONG_WIDTH, FIELDS = 10, 20, 8     # columns of a field, in the standard and in the long format; fields of a card
CELSIUS_BELOW = 200.0   # K: a room temperature below this is likely one in degrees Celsius
EXPANSION = 0.02        # of the volume, at which the tensions of both programs are compared


class Scale(NamedTuple):
    """SI values of the units of a file: kg, m, s."""

    mass: float
    length: float
    time: float

    @property
    def density(self) -> float:
        """kg/m3 of its unit."""
        return self.mass / self.length**3

    @property
    def pressure(self) -> float:
        """Pa, and J/m3, of its unit."""
        return self.mass / (self.length * self.time**2)

    @property
    def speed(self) -> float:
        """m/s of its unit."""
        return self.length / self.time


def scale_of(text: str) -> Scale:
    """The units of mass, length and time in a text such as "g cm us" or "tonne mm s"; DeckError for another."""
    words = text.split()
    try:
        if len(words) != 3:
            raise UnitError("expected three units, of mass, length and time")
        factors = [1000.0 if word in ("t", "ton", "tonne") and unit == "kg" else parse(f"1 {word}", unit)
                   for word, unit in zip(words, ("kg", "m", "s"))]
    except UnitError as error:
        raise DeckError.single("command line", None, "--units", error.message, error.hint or 'write --units "g cm us"') from None
    return Scale(*factors)


def read_cards(text: str, file: str) -> dict[str, dict[str, float]]:
    """{keyword: {field: number}} of the cards in a keyword file that are known here; DeckError for what cannot be read."""
    found: dict[str, dict[str, float]] = {}
    here, rows, titled, usual, width = None, 0, False, WIDTH, WIDTH
    for number, line in enumerate(text.splitlines(), start=1):
        if line.startswith("$") or not line.strip():
            continue
        if line.startswith("*"):
            name, *options = line[1:].strip().upper().split() or [""]
            if name == "KEYWORD" and {"LONG=Y", "LONG=K"} & set(options):
                usual = LONG_WIDTH
            width = LONG_WIDTH if "+" in (name[-1:], *options) else WIDTH if "-" in (name[-1:], *options) else usual
            name = name.rstrip("+-%")
            titled = name.endswith("_TITLE")
            here = NUMBERS.get(name.removesuffix("_TITLE"), name.removesuffix("_TITLE"))
            rows = 0
            if here in found:
                raise DeckError.single(file, number, f"*{here}", "appears twice", "give a file with one material")
            if here in CARDS:
                found[here] = {}
            elif here.startswith(("MAT_", "EOS_")):
                raise DeckError.single(file, number, f"*{printable(here, 40)}", "this card is not supported, and without it the material "
                                       "is another", f"remove it if it is not needed; known: {', '.join('*' + name for name in CARDS)}")
        elif titled:
            titled = False
        elif here in CARDS and rows < len(CARDS[here]):
            names = CARDS[here][rows]
            found[here] |= {name: value for name, value in zip(names, _fields(line, names, width, file, number)) if name}
            rows += 1
    for name, card in found.items():
        if LAST[name] not in card:
            raise DeckError.single(file, None, f"*{name}", f"the card ends before the line with {LAST[name]}", "add the missing lines")
    return found


def _fields(line: str, names, width: int, file: str, number: int) -> list[float]:
    """The numbers of one card; blank fields are 0, identifiers may be words."""
    if "," not in line and line[FIELDS * width:].strip():
        raise DeckError.single(file, number, names[0], f"the line goes on beyond its {FIELDS} fields of {width} columns",
                               "a file in the long format begins with *KEYWORD LONG=Y")
    given = line.split(",") if "," in line else [line[k:k + width] for k in range(0, max(len(line.rstrip()), 1), width)]
    values = []
    for name, field in zip(names, [*given, *[""] * len(names)]):
        word = field.strip()
        try:
            values.append(0.0 if not word or name in ("EOSID", "MID") else float(word))
        except ValueError:
            hint = "parameters (&NAME) must be replaced by their numbers" if word.startswith("&") else f"fields are {width} columns wide"
            raise DeckError.single(file, number, name, f"'{printable(word, 30)}' is not a number", hint) from None
    return values


def material_tables(cards: dict[str, dict[str, float]], scale: Scale, file: str, density: float | None = None) -> tuple[dict, list[str]]:
    """(tables of a material in SI, sentences on what the cards say and the tables do not).

    density   kg/m3, where no MAT card gives it. Raises `DeckError` for cards that make no material of this package.
    """
    strength = cards.get("MAT_JOHNSON_COOK")
    ground = strength or cards.get("MAT_HIGH_EXPLOSIVE_BURN")
    if ground and density is not None:
        raise DeckError.single(file, None, "--density", f"the MAT card already gives the density, RO = {ground['RO']:g}", "omit --density")
    rho0 = ground["RO"] * scale.density if ground else density
    curves = [name for name in ("EOS_GRUNEISEN", "EOS_JWL") if name in cards]
    if len(curves) != 1:
        found = ", found " + " and ".join(f"*{name}" for name in curves) if curves else ""
        raise DeckError.single(file, None, "*EOS", "one equation of state is needed" + found,
                               "supported: " + ", ".join(f"*{name}" for name in CARDS if name.startswith("EOS")))
    if rho0 is None or not rho0 > 0.0:
        raise DeckError.single(file, None, curves[0], "the density is not given", "add the MAT card, or --density")
    left: list[str] = []
    tables: dict[str, Any] = {"eos": (_gruneisen if curves == ["EOS_GRUNEISEN"] else _jwl)(cards[curves[0]], scale, rho0, file)}
    if strength:
        if strength.get("RATEOP", 0.0):
            raise DeckError.single(file, None, "*MAT_JOHNSON_COOK", f"the rate form RATEOP = {strength['RATEOP']:g} is not supported",
                                   "only RATEOP = 0, the factor 1 + C ln(rate/EPSO), has a law in hugoniot")
        tables["strength"], heat = _johnson_cook(strength, scale), strength["CP"] * scale.speed**2
        if heat > 0.0:
            tables["eos"]["specific_heat"] = heat
            tables["eos"].setdefault("reference_temperature", strength["TR"])
        if strength["TR"] < CELSIUS_BELOW:
            left.append(f"TR = {strength['TR']:g} and TM = {strength['TM']:g} are read in kelvin; if the card counts from another "
                        "zero, such as degrees Celsius, correct both temperatures, and reference_temperature if it is given")
        if any(strength.get(f"D{k}", 0.0) for k in range(1, 6)):
            left.append("the damage constants D1 to D5 are omitted: hugoniot has no such fracture law")
        if strength.get("PC", 0.0):
            left.append(f"the pressure cut-off PC = {strength['PC'] * scale.pressure:.4g} Pa is omitted; "
                        "[material.NAME.fracture] sets one")
    if "MAT_HIGH_EXPLOSIVE_BURN" in cards:
        left.append(f"the burn by D = {cards['MAT_HIGH_EXPLOSIVE_BURN']['D'] * scale.speed:.6g} m/s is omitted: the table is that of the "
                    "products; [material.NAME.burn] sets one")
    return tables, left


def _gruneisen(card: dict[str, float], scale: Scale, rho0: float, file: str) -> dict[str, Any]:
    if card.get("E0", 0.0) != 0.0 or card.get("V0", 1.0) not in (0.0, 1.0):
        raise DeckError.single(file, None, "*EOS_GRUNEISEN", "an initial energy E0 or volume V0 on the card is not supported",
                               "set E0 = 0 and V0 = 1, and give the state in the region of the deck")
    if card.get("LCID", 0.0):
        raise DeckError.single(file, None, "*EOS_GRUNEISEN", "a curve of energy deposition (LCID) is not supported",
                               "set LCID = 0, and give a [[heat_source]] in the deck")
    table = {"law": "mie_gruneisen", "rho0": rho0, "c0": card["C"] * scale.speed, "gamma0": card["GAMAO"]}
    if not (card["S2"] or card["S3"] or card["A"]):
        return table | {"s": card["S1"]}
    return table | {"law": "mie_gruneisen_cubic", "s1": card["S1"], "s2": card["S2"], "s3": card["S3"], "gamma_form": "linear",
                    "gamma_slope": card["A"]}


def tension_note(card: dict[str, float], eos: Any, scale: Scale) -> str:
    """How far the tension of this package's law is from LS-DYNA's, at `EXPANSION` without energy; eos: the law made of the card."""
    rho0, mu = float(reference_state(eos)[0]), 1.0 / (1.0 + EXPANSION) - 1.0
    theirs = rho0 * (card["C"] * scale.speed) ** 2 * mu
    less = 1.0 - float(pressure(rho0 * (1.0 + mu), 0.0, eos)) / theirs
    return (f"in tension LS-DYNA takes p = rho0 C^2 mu + (gamma0 + a mu) E, hugoniot an isentrope of the same initial slope; at a volume "
            f"{EXPANSION:.0%} above the initial one, the tension in hugoniot is {abs(less):.1%} {'lower' if less > 0.0 else 'higher'}")


def _jwl(card: dict[str, float], scale: Scale, rho0: float, file: str) -> dict[str, Any]:
    if card.get("VO", 0.0) not in (0.0, 1.0):
        raise DeckError.single(file, None, "*EOS_JWL", "an initial volume VO on the card is not supported",
                               "set VO = 1, and give the state in the region of the deck")
    return {"law": "jwl", "a": card["A"] * scale.pressure, "b": card["B"] * scale.pressure, "r1": card["R1"], "r2": card["R2"],
            "omega": card["OMEG"], "rho0": rho0, "e0": card["E0"] * scale.pressure}


def _johnson_cook(card: dict[str, float], scale: Scale) -> dict[str, Any]:
    shear = card["G"] or (card["E"] / (2.0 * (1.0 + card["PR"])))
    return {"law": "johnson_cook", "shear_modulus": shear * scale.pressure, "yield_stress": card["A"] * scale.pressure,
            "hardening_coefficient": card["B"] * scale.pressure, "hardening_exponent": card["N"], "rate_coefficient": card["C"],
            "thermal_exponent": card["M"], "room_temperature": card["TR"], "melt_temperature": card["TM"],
            "reference_rate": card["EPSO"] / scale.time}
